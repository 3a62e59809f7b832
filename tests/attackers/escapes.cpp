// SPDX-License-Identifier: MIT
//
// Programs that want out of the box, or more of the machine than is theirs: `escapes NAME MARKER`,
// or a probe that is asked by that name.
// As in hostile.cpp, what one gets is printed as a line that starts with GOT.
#include <fcntl.h>
#include <sched.h>
#include <sys/eventfd.h>
#include <sys/file.h>
#include <sys/inotify.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <sys/mount.h>
#include <sys/personality.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/timex.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <map>
#include <string>

#include "../support/asked_name.h"

namespace {

void wantRefused(const char *what, long result) {
    if (result >= 0)
        std::printf("GOT %s\n", what);
}

void opensFilesOfTheHost() {
    for (const char *path :
         {"/etc/hostname", "/etc/ssl", "/proc/cpuinfo", "/sys/class", "/boot", "/srv", "/opt",
          "/var/cache/norigrade", "/usr/bin", "/usr/include", "/usr/share", "/dev/kmsg",
          "/dev/fuse", "/dev/kvm", "/../etc/passwd", "/tmp/../../etc/passwd"})
        wantRefused(path, ::open(path, O_RDONLY | O_NONBLOCK));
}

void climbsOutOfTheRoot() {
    ::chdir("/");
    for (int i = 0; i < 50; ++i)
        ::chdir("..");
    wantRefused("the host's root", ::open("etc/passwd", O_RDONLY));
    wantRefused("a root by openat", ::openat(AT_FDCWD, "../../../etc/passwd", O_RDONLY));
    ::mkdir("/tmp/jail", 0700);
    wantRefused("a root of its own", ::chroot("/tmp/jail"));
    wantRefused("another root", ::syscall(SYS_pivot_root, "/tmp/jail", "/tmp/jail"));
}

void mountsAnew() {
    wantRefused("a writable root", ::mount("", "/", "", MS_REMOUNT | MS_BIND, nullptr));
    wantRefused("/proc", ::mount("proc", "/tmp", "proc", 0, nullptr));
    wantRefused("a bind", ::mount("/sentinel", "/tmp/x", "", MS_BIND, nullptr));
    wantRefused("an unmount", ::umount2("/sentinel", MNT_DETACH));
    wantRefused("fsopen", ::syscall(SYS_fsopen, "proc", 0));
    wantRefused("open_tree", ::syscall(SYS_open_tree, AT_FDCWD, "/", 1));
}

void makesNamespaces() {
    for (const int flag : {CLONE_NEWUSER, CLONE_NEWNS, CLONE_NEWPID, CLONE_NEWNET, CLONE_NEWIPC,
                           CLONE_NEWUTS, CLONE_NEWCGROUP})
        wantRefused("a namespace", ::unshare(flag));
    wantRefused("a namespace of another", ::setns(0, 0));
}

void makesDevices() {
    wantRefused("a memory device", ::mknod("/tmp/mem", S_IFCHR | 0600, 0x101));
    wantRefused("a disk", ::mknod("/tmp/disk", S_IFBLK | 0600, 0x800));
    wantRefused("a device in /dev", ::mknod("/dev/mem", S_IFCHR | 0600, 0x101));
}

void linksToTheHost() {
    // A link may be made; what it leads to is the box's.
    ::symlink("/etc/passwd", "/tmp/passwd");
    wantRefused("through a link", ::open("/tmp/passwd", O_RDONLY));
    wantRefused("a second name of a bound file", ::link("/sentinel", "/tmp/sentinel"));
    ::symlink("/sentinel", "/tmp/write");
    wantRefused("writing through a link", ::open("/tmp/write", O_WRONLY));
    wantRefused("a new file in the root", ::open("/new", O_CREAT | O_WRONLY, 0600));
}

void changesTheSentinel() {
    wantRefused("chown", ::chown("/sentinel", 65534, 65534));
    const timespec times[2] = {};
    wantRefused("another time", ::utimensat(AT_FDCWD, "/sentinel", times, 0));
    wantRefused("an attribute", ::syscall(SYS_setxattr, "/sentinel", "user.x", "y", 1, 0));
    const int fd = ::open("/sentinel", O_RDONLY);
    wantRefused("a flag", ::fcntl(fd, F_SETLEASE, F_WRLCK));
    wantRefused("writing by a mapping",
                ::mmap(nullptr, 4096, PROT_WRITE, MAP_SHARED, fd, 0) == MAP_FAILED ? -1 : 0);
    wantRefused("reopening for writing", ::open("/dev/fd/3", O_RDWR));
}

void becomesRoot() {
    wantRefused("setuid", ::setuid(0));
    wantRefused("setgid", ::setgid(0));
    wantRefused("setresuid", ::setresuid(0, 0, 0));
    wantRefused("setgroups", ::syscall(SYS_setgroups, 0, nullptr));
    // version 3, this process; then all capabilities
    unsigned header[2] = {0x20080522, 0};
    unsigned data[6] = {~0U, ~0U, ~0U, ~0U, ~0U, ~0U};
    wantRefused("capabilities", ::syscall(SYS_capset, header, data));
    wantRefused("securebits", ::prctl(28 /* PR_SET_SECUREBITS */, 1, 0, 0, 0));
    wantRefused("an ambient capability", ::syscall(SYS_prctl, 47, 2, 21, 0, 0));
}

void runsHelpers() {
    char name[] = "/bin/sh";
    char *argv[] = {name, nullptr};
    for (const char *program :
         {"/bin/sh", "/usr/bin/sudo", "/usr/bin/bwrap", "/bin/su", "/usr/bin/env"})
        wantRefused(program, ::execve(program, argv, nullptr));
    wantRefused("execveat", ::syscall(SYS_execveat, AT_FDCWD, "/bin/sh", argv, nullptr, 0));
}

/// It runs, as libraries' folders are there, but as nobody: if there is one, it says so itself.
void runsASetuidProgram() {
    char name[] = "/usr/lib/openssh/ssh-keysign";
    char *argv[] = {name, nullptr};
    ::execve(name, argv, nullptr);
}

void signalsOthers() {
    for (const int pid : {0, -1, 1})
        ::kill(pid == 0 ? ::getppid() : pid, pid == 1 ? SIGTERM : 0);
    wantRefused("a process of the host", ::kill(2'000'000, 0));
    wantRefused("pidfd_open", ::syscall(SYS_pidfd_open, 2'000'000, 0));
    wantRefused("kcmp", ::syscall(SYS_kcmp, ::getpid(), 1, 0, 0, 0));
    wantRefused("priority of others", ::setpriority(PRIO_USER, 1, -20));
}

void takesPriority() {
    const sched_param param{10};
    wantRefused("real time", ::sched_setscheduler(0, SCHED_FIFO, &param));
    wantRefused("round robin", ::sched_setscheduler(0, SCHED_RR, &param));
    wantRefused("nice", ::setpriority(PRIO_PROCESS, 0, -20));
    // To look starved by others, which costs nothing.
    const sched_param none{0};
    wantRefused("idle", ::sched_setscheduler(0, SCHED_IDLE, &none));
    wantRefused("batch", ::sched_setscheduler(0, SCHED_BATCH, &none));
    wantRefused("its own nice", ::setpriority(PRIO_PROCESS, 0, 19));
    cpu_set_t one;
    CPU_ZERO(&one);
    CPU_SET(0, &one);
    wantRefused("one processor", ::sched_setaffinity(0, sizeof(one), &one));
    wantRefused("disk priority", ::syscall(SYS_ioprio_set, 1, 0, 1 << 13));
    const rlimit more{RLIM_INFINITY, RLIM_INFINITY};
    for (const __rlimit_resource limit :
         {RLIMIT_CPU, RLIMIT_AS, RLIMIT_NPROC, RLIMIT_FSIZE, RLIMIT_NOFILE, RLIMIT_CORE})
        wantRefused("a limit", ::setrlimit(limit, &more));
}

void locksMemory() {
    const rlimit more{std::size_t{1} << 40U, std::size_t{1} << 40U};
    ::setrlimit(RLIMIT_MEMLOCK, &more);
    void *piece = ::mmap(nullptr, std::size_t{256} << 20U, PROT_READ | PROT_WRITE,
                         MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (piece != MAP_FAILED)
        wantRefused("256 MiB locked", ::mlock(piece, std::size_t{256} << 20U));
}

void setsTheMachine() {
    const timespec time{1, 0};
    wantRefused("the clock", ::clock_settime(CLOCK_REALTIME, &time));
    timex adjust{};
    adjust.modes = ADJ_FREQUENCY;
    wantRefused("the clock's rate", ::adjtimex(&adjust));
    wantRefused("the host's name", ::sethostname("hostile", 7));
    wantRefused("a reboot", ::syscall(SYS_reboot, 0xfee1dead, 672274793, 0, nullptr));
    wantRefused("swap", ::syscall(SYS_swapon, "/tmp/swap", 0));
    wantRefused("the kernel's log", ::syscall(SYS_syslog, 3, nullptr, 0));
    wantRefused("a module", ::syscall(SYS_init_module, nullptr, 0, ""));
    wantRefused("accounting", ::syscall(SYS_acct, "/tmp/acct"));
    wantRefused("a quota", ::syscall(SYS_quotactl, 0, "/dev/sda", 0, nullptr));
    wantRefused("personality", ::personality(ADDR_NO_RANDOMIZE));
}

void triesRareCalls() {
    for (const long call : {SYS_bpf,
                            SYS_perf_event_open,
                            SYS_io_uring_setup,
                            SYS_userfaultfd,
                            SYS_keyctl,
                            SYS_add_key,
                            SYS_request_key,
                            SYS_memfd_secret,
                            SYS_fanotify_init,
                            SYS_open_by_handle_at,
                            SYS_name_to_handle_at,
                            SYS_modify_ldt,
                            SYS_mq_open,
                            SYS_semget,
                            SYS_shmget,
                            SYS_msgget,
                            SYS_vmsplice,
                            SYS_pidfd_getfd,
                            SYS_kexec_load,
                            SYS_io_setup})
        wantRefused(std::to_string(call).c_str(), ::syscall(call, 1, 0, 0, 0, 0, 0));
}

void writesToATerminal() {
    char letter = 'x';
    for (int fd = 0; fd < 3; ++fd)
        wantRefused("a key typed", ::ioctl(fd, TIOCSTI, &letter));
    wantRefused("a terminal", ::open("/dev/tty", O_RDWR));
    wantRefused("a terminal taken", ::ioctl(0, TIOCSCTTY, 1));
}

void makesManyFiles() {
    long files = 0;
    for (; files < 20'000; ++files) {
        const int fd = ::open(("/tmp/f" + std::to_string(files)).c_str(), O_CREAT | O_WRONLY, 0600);
        if (fd < 0)
            break;
        ::close(fd);
    }
    std::printf("files %ld\n", files); // they end with the box
}

void opensManyDescriptors() {
    int count = 0;
    while (count < 100'000 && ::eventfd(0, 0) >= 0)
        ++count;
    std::printf("descriptors %d\n", count);
    if (count > 256)
        std::puts("GOT more descriptors than its limit");
}

void fillsPipes() {
    long bytes = 0;
    std::string block(std::size_t{1} << 16U, 'x');
    for (int i = 0; i < 200; ++i) {
        int ends[2];
        if (::pipe2(ends, O_NONBLOCK) != 0)
            break;
        ::fcntl(ends[1], F_SETPIPE_SZ, 1 << 20);
        for (ssize_t count = 0; (count = ::write(ends[1], block.data(), block.size())) > 0;)
            bytes += count;
    }
    std::printf("pipes %ld\n", bytes);
}

void watchesFiles() {
    const int fd = ::inotify_init1(IN_NONBLOCK);
    for (int i = 0; i < 10'000; ++i)
        ::inotify_add_watch(fd, "/sentinel", IN_ALL_EVENTS);
    char events[4096];
    wantRefused("an event of the host", ::read(fd, events, sizeof events));
}

void holdsALock() {
    const int fd = ::open("/sentinel", O_RDONLY);
    ::flock(fd, LOCK_EX); // may be had; nothing of ours waits for one
    for (;;)
        ::pause();
}

void ignoresSignals() {
    for (int signal = 1; signal < SIGRTMAX; ++signal)
        ::signal(signal, SIG_IGN);
    for (;;)
        ::pause();
}

void handlesItsEnd() {
    ::signal(SIGXCPU, [](int) { ::signal(SIGXCPU, SIG_IGN); });
    for (volatile bool ever = true; ever;) {
    }
}

void pretendsATimeOut() {
    ::raise(SIGXCPU);
}

void pretendsToBeKilled() {
    ::kill(::getpid(), SIGKILL);
}

void readsNothingFromStdin() {
    char bytes[16];
    if (::read(STDIN_FILENO, bytes, sizeof bytes) > 0)
        std::puts("GOT input");
}

void dumpsCore() {
    ::prctl(4 /* PR_SET_DUMPABLE */, 1, 0, 0, 0);
    std::abort();
}

void eatsTheStack() {
    char block[65536];
    std::memset(block, 1, sizeof block);
    volatile char *keep = block;
    if (keep[0] == 1)
        eatsTheStack();
    keep[1] = 0;
}

void writesControlText() {
    std::puts("\x1b]0;title\x07\x1b[2J\x1b[31mPASSED\x1b[0m \xff\xfe \xe2\x80\xae<script>");
}

const std::map<std::string, void (*)()> kPrograms = {
    {"becomes_root", becomesRoot},
    {"changes_the_sentinel", changesTheSentinel},
    {"climbs_out_of_the_root", climbsOutOfTheRoot},
    {"dumps_core", dumpsCore},
    {"eats_the_stack", eatsTheStack},
    {"fills_pipes", fillsPipes},
    {"handles_its_end", handlesItsEnd},
    {"holds_a_lock", holdsALock},
    {"ignores_signals", ignoresSignals},
    {"links_to_the_host", linksToTheHost},
    {"locks_memory", locksMemory},
    {"makes_devices", makesDevices},
    {"makes_many_files", makesManyFiles},
    {"makes_namespaces", makesNamespaces},
    {"mounts_anew", mountsAnew},
    {"opens_files_of_the_host", opensFilesOfTheHost},
    {"opens_many_descriptors", opensManyDescriptors},
    {"pretends_a_time_out", pretendsATimeOut},
    {"pretends_to_be_killed", pretendsToBeKilled},
    {"reads_stdin", readsNothingFromStdin},
    {"runs_a_setuid_program", runsASetuidProgram},
    {"runs_helpers", runsHelpers},
    {"sets_the_machine", setsTheMachine},
    {"signals_others", signalsOthers},
    {"takes_priority", takesPriority},
    {"tries_rare_calls", triesRareCalls},
    {"watches_files", watchesFiles},
    {"writes_control_text", writesControlText},
    {"writes_to_a_terminal", writesToATerminal},
};

} // namespace

int main(int argc, char **argv) {
    const auto program = kPrograms.find(test::askedName(argc, argv));
    if (program == kPrograms.end())
        return 99;
    // Whoever starts it by hand, outside of a box, comes to no harm.
    constexpr pid_t kFewProcesses = 10;
    if (::getuid() != 65534 || ::getpid() > kFewProcesses) {
        std::puts("GOT out of the box");
        return 98;
    }
    program->second();
    std::puts("tried");
    return 0;
}
