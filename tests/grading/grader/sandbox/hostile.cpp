// SPDX-License-Identifier: MIT
//
// A program that tries to do harm: `hostile MODE [MARKER]`, or a probe that is asked by that name.
// Whatever it gets that it should not have is printed as a line that starts with GOT; the last line
// of a mode that comes to its end is "tried". MARKER only makes its processes easy to find from
// outside.
#include <dirent.h>
#include <fcntl.h>
#include <linux/sched.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/ptrace.h>
#include <sys/resource.h>
#include <sys/shm.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

#include "../../../support/asked_name.h"
#include <arpa/inet.h>

extern char **environ; // NOLINT(readability-redundant-declaration): not in every <unistd.h>

namespace {

void got(const char *what) {
    std::printf("GOT %s\n", what);
}

/// For calls that return a negative value when they are refused.
void wantRefused(const char *what, long result) {
    if (result >= 0)
        got(what);
}

void rest() {
    for (;;)
        ::pause();
}

void spin() {
    for (volatile bool ever = true; ever;) {
    }
}

void fork() {
    // Children rest, so that they are all there at the same time.
    int children = 0;
    while (children < 5000) {
        const pid_t child = ::fork();
        if (child < 0)
            break;
        if (child == 0)
            rest();
        ++children;
    }
    std::printf("children %d\n", children);
}

void forkAndRest() {
    fork();
    std::fflush(stdout);
    rest();
}

void forkOtherwise() {
    wantRefused("vfork", ::syscall(SYS_vfork));
    clone_args arguments{};
    arguments.exit_signal = SIGCHLD;
    const long child = ::syscall(SYS_clone3, &arguments, sizeof arguments);
    if (child == 0)
        ::_exit(0);
    wantRefused("clone3", child);
}

void startThreads() {
    std::vector<std::thread> threads;
    try {
        while (threads.size() < 5000)
            threads.emplace_back(rest);
    } catch (const std::system_error &) {
        // Joining would wait for ever: the threads are left to the end of the process.
    }
    std::printf("threads %zu\ntried\n", threads.size());
    std::fflush(stdout);
    ::_exit(0);
}

void eatMemory() {
    constexpr std::size_t kPiece = std::size_t{1} << 20;
    for (std::size_t i = 0; i < 100'000; ++i) {
        void *piece =
            ::mmap(nullptr, kPiece, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
        if (piece == MAP_FAILED) {
            std::printf("mebibytes %zu\n", i);
            return;
        }
        std::memset(piece, 1, kPiece);
    }
}

/// System V segments that no process has attached would count as nobody's.
void parkMemory() {
    wantRefused("shmget", ::shmget(IPC_PRIVATE, 1 << 20, IPC_CREAT | 0600));
    wantRefused("memfd_create", ::syscall(SYS_memfd_create, "parked", 0U));
    wantRefused("msgget", ::syscall(SYS_msgget, IPC_PRIVATE, IPC_CREAT | 0600));
}

std::size_t fill(const std::string &folder) {
    const std::vector<char> block(std::size_t{1} << 20, 'x');
    std::size_t written = 0;
    for (int i = 0; i < 400; ++i) {
        const int fd = ::open((folder + "/fill" + std::to_string(i)).c_str(),
                              O_CREAT | O_WRONLY | O_EXCL, 0600);
        if (fd < 0)
            break;
        for (int k = 0; k < 4; ++k) {
            const ssize_t count = ::write(fd, block.data(), block.size());
            written += count > 0 ? static_cast<std::size_t>(count) : 0;
        }
        ::close(fd);
    }
    return written;
}

void fillFolders() {
    for (const char *folder : {"/", "/dev", "/usr", "/usr/lib", "/dev/pts"}) {
        if (fill(folder) > 0)
            std::printf("GOT bytes into %s\n", folder);
    }
    for (const char *folder : {"/dev/shm", "/tmp"})
        std::printf("%s %zu\n", folder, fill(folder));
}

void writeLargeFile() {
    ::signal(SIGXFSZ, SIG_IGN);
    const std::vector<char> block(std::size_t{1} << 20, 'x');
    const int fd = ::open("/tmp/large", O_CREAT | O_WRONLY, 0600);
    int blocks = 0;
    while (::write(fd, block.data(), block.size()) == static_cast<ssize_t>(block.size()))
        ++blocks;
    std::printf("blocks %d\n", blocks);
}

void floodLog() {
    const std::string line(4096, 'x');
    for (;;) {
        if (::write(STDOUT_FILENO, line.data(), line.size()) < 0)
            return;
    }
}

void printMuch() { // 300 kB, all before it ends
    const std::string line(1000, 'x');
    for (int i = 0; i < 300; ++i)
        std::puts(line.c_str());
}

void killAll() {
    // -1 spares oneself; inside the box nobody else is there, so "no such process" is well.
    wantRefused("kill(-1)", ::kill(-1, SIGKILL));
    for (pid_t process = 3; process < 40'000; ++process) {
        if (process != ::getpid())
            wantRefused("kill(pid)", ::kill(process, SIGKILL));
    }
}

void connectOut() {
    wantRefused("socket", ::socket(AF_INET, SOCK_STREAM, 0));
    wantRefused("unix socket", ::socket(AF_UNIX, SOCK_STREAM, 0));
    wantRefused("netlink", ::socket(AF_NETLINK, SOCK_RAW, 0));
}

void attackKernel() {
    wantRefused("ptrace", ::ptrace(PTRACE_TRACEME, 0, nullptr, nullptr));
    wantRefused("ptrace of the parent", ::ptrace(PTRACE_SEIZE, ::getppid(), nullptr, nullptr));
    wantRefused("unshare", ::unshare(CLONE_NEWUSER));
    wantRefused("unshare mount", ::unshare(CLONE_NEWNS));
    const long child = ::syscall(SYS_clone, CLONE_NEWUSER | SIGCHLD, nullptr, nullptr, nullptr, 0);
    if (child == 0)
        ::_exit(0);
    wantRefused("clone with a user namespace", child);
    wantRefused("mount", ::syscall(SYS_mount, "none", "/tmp", "tmpfs", 0, nullptr));
    wantRefused("bpf", ::syscall(SYS_bpf, 0, nullptr, 0));
    unsigned long context = 0;
    wantRefused("io_setup", ::syscall(SYS_io_setup, 8, &context));
    wantRefused("io_uring_setup", ::syscall(SYS_io_uring_setup, 8, nullptr));
    wantRefused("userfaultfd", ::syscall(SYS_userfaultfd, 0));
    wantRefused("keyctl", ::syscall(SYS_keyctl, 0, -3, 0));
    wantRefused("perf_event_open", ::syscall(SYS_perf_event_open, nullptr, 0, -1, -1, 0));
    wantRefused("chroot", ::chroot("/tmp"));
    wantRefused("setuid", ::setuid(0));
    const rlimit more{RLIM_INFINITY, RLIM_INFINITY};
    wantRefused("more CPU time", ::setrlimit(RLIMIT_CPU, &more));
    wantRefused("more memory", ::setrlimit(RLIMIT_AS, &more));
}

/// bubblewrap runs as the first process and tells our end: it must not be led to tell another.
void attackFirstProcess() {
    for (int signal = 1; signal <= SIGRTMAX; ++signal)
        ::kill(1, signal); // "sent", but a namespace's first process does not get it
    const int first = static_cast<int>(::syscall(SYS_pidfd_open, 1, 0));
    ::syscall(SYS_pidfd_send_signal, first, SIGKILL, nullptr, 0);
    wantRefused("a descriptor of the first process", ::syscall(SYS_pidfd_getfd, first, 20, 0));
    const rlimit none{};
    wantRefused("a limit for the first process", ::prlimit(1, RLIMIT_CPU, &none, nullptr));
    char word[8] = {};
    iovec here{word, sizeof word};
    iovec there{&here, sizeof word};
    wantRefused("its memory", ::process_vm_readv(1, &here, 1, &there, 1, 0));
    wantRefused("its memory to write", ::process_vm_writev(1, &here, 1, &there, 1, 0));
    for (int fd = 3; fd < 256; ++fd)
        wantRefused("a descriptor to forge on", ::write(fd, "{\"exit-code\": 0}\n", 17));
}

/// A filter that knows the calls of one machine only could be gone round by those of another.
void callOtherMachines() {
#ifdef __x86_64__
    constexpr long kX32 = 0x40000000;
    wantRefused("a call of x32", ::syscall(kX32 + SYS_getpid));
    long result = 20; // getpid() of i386
    __asm__ volatile("int $0x80" : "+a"(result) : : "memory", "r8", "r9", "r10", "r11");
    wantRefused("a call of i386", result);
#else
    ::raise(SIGSYS);
#endif
}

void lookAround() {
    for (const char *path : {"/etc/passwd", "/etc/shadow", "/proc/self/maps", "/proc/1/environ",
                             "/proc/self/mountinfo", "/sys/kernel", "/root", "/home", "/var",
                             "/srv", "/run", "/usr/local/bin", "/dev/sda", "/dev/mem"}) {
        const int fd = ::open(path, O_RDONLY);
        if (fd >= 0)
            got(path);
    }
    for (char **variable = environ; *variable != nullptr; ++variable)
        std::printf("environment %s\n", *variable);
    DIR *root = ::opendir("/");
    while (const dirent *entry = ::readdir(root))
        std::printf("root %s\n", entry->d_name);
    ::closedir(root);
    std::printf("uid %u gid %u session %s\n", ::getuid(), ::getgid(),
                ::open("/dev/tty", O_RDWR) < 0 ? "without terminal" : "with terminal");
}

void writeHost() {
    for (const char *path : {"/sentinel", "/hostile"}) {
        wantRefused("a file to write", ::open(path, O_WRONLY));
        wantRefused("chmod", ::chmod(path, 0777));
        wantRefused("unlink", ::unlink(path));
        wantRefused("rename", ::rename(path, "/tmp/moved"));
        wantRefused("truncate", ::truncate(path, 0));
    }
}

void listDescriptors() {
    for (int fd = 0; fd < 1024; ++fd) {
        if (::fcntl(fd, F_GETFD) >= 0)
            std::printf("descriptor %d\n", fd);
    }
}

void readDescriptors() {
    for (int fd = 3; fd < 20; ++fd) {
        char text[64] = {};
        if (::pread(fd, text, sizeof text - 1, 0) > 0)
            std::printf("%d holds %s\n", fd, text);
    }
}

void daemonise() {
    const pid_t child = ::fork();
    if (child < 0)
        ::_exit(1); // nothing to leave behind: not tried
    if (child > 0)
        return;
    ::setsid();
    if (::fork() != 0)
        ::_exit(0);
    ::signal(SIGTERM, SIG_IGN);
    ::signal(SIGHUP, SIG_IGN);
    rest(); // holds the log open
}

void stopSelf() {
    ::kill(::getpid(), SIGSTOP);
}

void ignoreCpuSignal() {
    ::signal(SIGXCPU, SIG_IGN);
    spin();
}

void crash() {
    ::raise(SIGSEGV);
}

void exitWithMinusOne() {
    ::_exit(-1);
}

void exitWithSeven() {
    std::puts("PASSED");
    std::fflush(stdout);
    ::_exit(7);
}

const std::map<std::string, void (*)()> kModes = {
    {"attack_first_process", attackFirstProcess},
    {"attack_kernel", attackKernel},
    {"call_other_machines", callOtherMachines},
    {"connect_out", connectOut},
    {"crash", crash},
    {"daemonise", daemonise},
    {"eat_memory", eatMemory},
    {"exit_with_minus_one", exitWithMinusOne},
    {"exit_with_seven", exitWithSeven},
    {"fill_folders", fillFolders},
    {"flood_log", floodLog},
    {"fork", fork},
    {"fork_and_rest", forkAndRest},
    {"fork_otherwise", forkOtherwise},
    {"ignore_cpu_signal", ignoreCpuSignal},
    {"kill_all", killAll},
    {"list_descriptors", listDescriptors},
    {"look_around", lookAround},
    {"park_memory", parkMemory},
    {"print_much", printMuch},
    {"read_descriptors", readDescriptors},
    {"rest", rest},
    {"spin", spin},
    {"start_threads", startThreads},
    {"stop_self", stopSelf},
    {"write_host", writeHost},
    {"write_large_file", writeLargeFile},
};

} // namespace

int main(int argc, char **argv) {
    const auto mode = kModes.find(test::askedName(argc, argv));
    if (mode == kModes.end())
        return 99;
    // Whoever starts it by hand, outside of a box, comes to no harm.
    constexpr pid_t kFewProcesses = 10;
    if (::getuid() != 65534 || ::getpid() > kFewProcesses) {
        std::puts("GOT out of the box");
        return 98;
    }
    mode->second();
    std::puts("tried");
    return 0;
}
