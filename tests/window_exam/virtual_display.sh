# Sourced by the exams of the windows: real input events in a virtual display with a software
# renderer, and screenshots without any display. They set `out`, where pictures go.
failures=0
export LIBGL_ALWAYS_SOFTWARE=1

check() { # TEXT COMMAND...
    local text=$1
    shift
    if "$@"; then echo "ok    $text"; else echo "WRONG $text"; failures=$((failures + 1)); fi
}

without_display() { env -u DISPLAY -u WAYLAND_DISPLAY "$@"; }

# Nothing that could be drawn on: neither a display nor EGL.
without_graphics() { without_display env __EGL_VENDOR_LIBRARY_FILENAMES=/nowhere "$@"; }

# says_why TEXT COMMAND...: exit code 2 and one line that says why.
says_why() {
    local text=$1 code=0 said
    shift
    said=$("$@" 2>&1) || code=$?
    check "$text: exit 2 and one sentence" test "$code" = 2 -a "$(wc -l <<<"$said")" = 1
    echo "      $said"
}

start_display() {
    local display=:$((100 + RANDOM % 400))
    Xvfb "$display" -screen 0 1280x800x24 -nolisten tcp >/dev/null 2>&1 &
    server=$!
    window=
    trap 'kill $window "$server" 2>/dev/null || true' EXIT
    export DISPLAY=$display
    local _
    for _ in $(seq 50); do xdotool getdisplaygeometry >/dev/null 2>&1 && break; sleep 0.1; done
}

# wait_for_window NAME: a minute at most; then it has the keyboard.
wait_for_window() {
    local _
    for _ in $(seq 600); do
        # a window that is not drawn yet cannot have the keyboard
        if xdotool search --onlyvisible --name "$1" windowfocus >/dev/null 2>&1; then
            sleep 1
            return
        fi
        sleep 0.1
    done
    return 1
}

keys() { for key in "$@"; do xdotool key "$key"; sleep 0.2; done; }

picture() { import -window root "$out/$1.png"; }

same_picture() { [ "$(compare -metric AE "$out/$1.png" "$out/$2.png" null: 2>&1)" = 0 ]; }

wait_for_file() {
    local _
    for _ in $(seq "${2:-60}"); do [ -e "$1" ] && return; sleep 0.1; done
    return 1
}

ticks() { awk '{print $14 + $15}' "/proc/$window/stat"; }

# is_idle TEXT: 10 s.
is_idle() {
    local before percent
    before=$(ticks)
    sleep 10
    percent=$(awk -v t="$(($(ticks) - before))" -v hz="$(getconf CLK_TCK)" 'BEGIN {print t / hz * 10}')
    check "$1 takes $percent % of a core, below 3" awk -v p="$percent" 'BEGIN {exit !(p < 3)}'
}

finish() {
    echo "$failures wrong; the pictures are in $out"
    [ "$failures" = 0 ]
}
