// SPDX-License-Identifier: MIT
#include "launch.h"

#include <grader/error.h>
#include <grader/sandbox/cgroup.h>
#include <grader/sandbox/orphans.h>
#include <grader/sandbox/seccomp_filter.h>

#include <fmt/core.h>

#include <fcntl.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <memory>

namespace grader {

namespace {

constexpr uid_t kNobody = 65534;
constexpr uid_t kFirstUser = 1'000'000'000; ///< of those that root's boxes run as
constexpr uid_t kBoxesAtOnce = 64;
constexpr int kFirstDescriptor = 3; ///< BoxSpec::descriptors
constexpr int kStatusFd = 20;
constexpr int kFilterFd = 21;
constexpr int kParkedFds = 100; ///< descriptors wait above before they get their numbers
constexpr std::size_t kMostDescriptors = kStatusFd - kFirstDescriptor;

struct Pipe {
    Descriptor read;
    Descriptor write;
};

Pipe makePipe() {
    std::array<int, 2> fds{};
    if (::pipe2(fds.data(), O_CLOEXEC) != 0)
        throw GraderError("no pipe can be made: too many files are open");
    return {Descriptor(fds[0]), Descriptor(fds[1])};
}

/// Threads and processes of a user: RLIMIT_NPROC counts all of them.
rlim_t processesOf(uid_t user) {
    rlim_t count = 0;
    std::error_code error;
    for (const auto &entry : std::filesystem::directory_iterator("/proc", error)) {
        struct stat status {};

        if (::stat(entry.path().c_str(), &status) == 0 && status.st_uid == user &&
            std::isdigit(static_cast<unsigned char>(entry.path().filename().string()[0])) != 0) {
            for (const auto &task :
                 std::filesystem::directory_iterator(entry.path() / "task", error)) {
                (void)task;
                ++count;
            }
        }
    }
    return count;
}

// From here to exec only calls that are safe after vfork(): the child shares the grader's memory.

[[noreturn]] void childFails(const char *what) {
    const char *reason = ::strerrordesc_np(errno);
    for (const char *text : {"sandbox: ", what, ": ", reason, "\n"}) {
        if (::write(STDERR_FILENO, text, std::strlen(text)) < 0)
            break;
    }
    ::_exit(1);
}

struct ChildPlan {
    char *const *argv;
    const int *descriptors;
    int descriptorCount;
    const int *groups; ///< Cgroup::entrances()
    int groupCount;
    int logFd;
    int statusFd;
    int filterFd;
    pid_t grader;
    bool asRoot;
    uid_t user; ///< to become as root
    rlim_t processes;
    rlim_t addressBytes;
    const BoxLimits *limits;
};

void limit(__rlimit_resource resource, rlim_t soft, rlim_t hard, const char *what) {
    const rlimit value{soft, hard};
    if (::setrlimit(resource, &value) != 0)
        childFails(what);
}

/// Not with the C library's functions, which would change the user of all of the grader's threads.
/// The kernel forbids others to trace the shared memory from here on, the grader's, too: it leaves
/// no core file.
bool become(uid_t user) {
    return ::syscall(SYS_setgroups, 0, nullptr) == 0 &&
           ::syscall(SYS_setresgid, user, user, user) == 0 &&
           ::syscall(SYS_setresuid, user, user, user) == 0;
}

void setLimits(const ChildPlan &plan, rlim_t processes) {
    const auto seconds = static_cast<rlim_t>((plan.limits->cpu + std::chrono::milliseconds(999)) /
                                             std::chrono::seconds(1));
    limit(RLIMIT_CPU, seconds, seconds + 1, "RLIMIT_CPU");
    limit(RLIMIT_AS, plan.addressBytes, plan.addressBytes, "RLIMIT_AS");
    limit(RLIMIT_FSIZE, plan.limits->fileBytes, plan.limits->fileBytes, "RLIMIT_FSIZE");
    limit(RLIMIT_CORE, 0, 0, "RLIMIT_CORE");
    limit(RLIMIT_NOFILE, 256, 256, "RLIMIT_NOFILE");
    limit(RLIMIT_NPROC, processes, processes, "RLIMIT_NPROC");
}

void giveDescriptors(const ChildPlan &plan) {
    // First out of the way of the final numbers (and of each other), then into place.
    const auto park = [](int fd) {
        const int parked = ::fcntl(fd, F_DUPFD, kParkedFds);
        if (parked < 0)
            childFails("a descriptor cannot be duplicated");
        return parked;
    };
    const int log = park(plan.logFd);
    const int status = park(plan.statusFd);
    const int filter = park(plan.filterFd);
    std::array<int, kMostDescriptors> own{};
    for (int i = 0; i < plan.descriptorCount; ++i)
        own[static_cast<std::size_t>(i)] = park(plan.descriptors[i]);
    const int null = ::open("/dev/null", O_RDONLY);
    if (null < 0)
        childFails("/dev/null");
    ::dup2(null, STDIN_FILENO);
    ::dup2(log, STDOUT_FILENO);
    ::dup2(log, STDERR_FILENO);
    for (int i = 0; i < plan.descriptorCount; ++i)
        ::dup2(own[static_cast<std::size_t>(i)], kFirstDescriptor + i);
    ::dup2(status, kStatusFd);
    ::dup2(filter, kFilterFd);
    ::close_range(static_cast<unsigned>(kFirstDescriptor + plan.descriptorCount), kStatusFd - 1, 0);
    ::close_range(kFilterFd + 1, ~0U, 0);
}

/// The grader's handlers must not run in the child, and what they would have caught while the child
/// starts (Ctrl-C reaches the grader's whole group) must not end it: to ignore a signal forgets a
/// pending one. What is ignored stays ignored, as after fork().
void forgetHandlers() {
    for (int signal = 1; signal <= SIGRTMAX; ++signal) {
        struct sigaction action {};

        if (::sigaction(signal, nullptr, &action) != 0 || action.sa_handler == SIG_IGN ||
            action.sa_handler == SIG_DFL)
            continue;
        for (const auto handler : {SIG_IGN, SIG_DFL}) {
            action = {};
            action.sa_handler = handler;
            ::sigaction(signal, &action, nullptr);
        }
    }
}

int runChild(void *argument) {
    const ChildPlan &plan = *static_cast<const ChildPlan *>(argument);
    ::dup2(plan.logFd, STDERR_FILENO); // for childFails()
    for (int i = 0; i < plan.groupCount; ++i) {
        if (::write(plan.groups[i], "0", 1) != 1) // the process that writes
            childFails("a process cannot be put into its control group");
    }
    giveDescriptors(plan);
    if (::setsid() < 0) // first: from here on signals to the grader's group do not come here
        childFails("setsid");
    forgetHandlers();
    sigset_t none;
    ::sigemptyset(&none);
    ::sigprocmask(SIG_SETMASK, &none, nullptr);
    rlim_t processes = plan.processes;
    if (plan.asRoot && !become(plan.user)) {
        // A container's root may have no users that far up: then all boxes share one.
        if (!become(kNobody))
            childFails("setresuid");
        processes *= kBoxesAtOnce;
    }
    setLimits(plan, processes);
    // Changing user has cleared it.
    ::prctl(PR_SET_PDEATHSIG, SIGKILL, 0, 0, 0);
    if (::getppid() != plan.grader) // it was killed before that
        ::_exit(1);
    if (::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0)
        childFails("no_new_privs");
    ::execv(kBubblewrap, plan.argv);
    childFails(kBubblewrap);
}

/// Like vfork(): this thread waits until the child has called exec or ended. fork() would mark all
/// of the grader's memory as to be copied on the next write, some hundred times per hand-in.
/// \return  the child, negative if there is none
pid_t startWithSharedMemory(ChildPlan &plan) {
    constexpr std::size_t kStackBytes = std::size_t{256} << 10;
    const auto stack = std::make_unique_for_overwrite<char[]>(kStackBytes);
    sigset_t all;
    sigset_t before;
    ::sigfillset(&all);
    ::pthread_sigmask(SIG_BLOCK, &all, &before);
    const pid_t child =
        ::clone(runChild, stack.get() + kStackBytes, CLONE_VM | CLONE_VFORK | SIGCHLD, &plan);
    ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
    return child;
}

} // namespace

std::vector<std::string> bubblewrapArguments(const BoxSpec &spec, int statusFd, int filterFd) {
    std::vector<std::string> arguments = {kBubblewrap,
                                          "--unshare-all",
                                          "--unshare-user",
                                          "--disable-userns",
                                          "--uid",
                                          "65534",
                                          "--gid",
                                          "65534",
                                          "--hostname",
                                          kBoxHostName,
                                          "--cap-drop",
                                          "ALL",
                                          "--new-session",
                                          "--die-with-parent",
                                          "--clearenv",
                                          "--setenv",
                                          "LANG",
                                          "C",
                                          "--setenv",
                                          "TMPDIR",
                                          "/tmp"};
    const auto add = [&](std::initializer_list<std::string> more) {
        arguments.insert(arguments.end(), more);
    };
    if (spec.mayFork) {
        add({"--setenv", "PATH", "/usr/bin", "--ro-bind", "/usr", "/usr"});
        // Where an administrator may have put the finished renderer, or this program's source.
        if (std::filesystem::exists("/usr/local"))
            add({"--size", "4096", "--tmpfs", "/usr/local", "--remount-ro", "/usr/local"});
    } else {
        add({"--ro-bind", "/usr/lib", "/usr/lib", "--ro-bind-try", "/usr/lib64", "/usr/lib64"});
    }
    add({"--symlink", "usr/lib", "/lib", "--symlink", "usr/lib64", "/lib64", "--symlink", "usr/bin",
         "/bin"});
    // bubblewrap's /dev and root are writable memory unless told otherwise.
    add({"--dev", "/dev", "--remount-ro", "/dev", "--size", "1048576", "--tmpfs", "/dev/shm"});
    add({"--size", std::to_string(spec.limits.temporaryBytes), "--tmpfs", "/tmp"});
    for (const BoxBind &bind : spec.binds)
        add({bind.writable ? "--bind" : "--ro-bind", bind.host.string(), bind.inside});
    add({"--remount-ro", "/", "--chdir", spec.workingFolder, "--json-status-fd",
         std::to_string(statusFd), "--seccomp", std::to_string(filterFd), "--"});
    arguments.insert(arguments.end(), spec.argv.begin(), spec.argv.end());
    return arguments;
}

Launched launch(const BoxSpec &spec, Cgroup *cgroup) {
    const bool asRoot = ::geteuid() == 0;
    std::vector<std::string> arguments = bubblewrapArguments(spec, kStatusFd, kFilterFd);
    std::vector<char *> argv;
    argv.reserve(arguments.size() + 1);
    for (std::string &argument : arguments)
        argv.push_back(argument.data());
    argv.push_back(nullptr);

    if (spec.descriptors.size() > kMostDescriptors)
        throw GraderError("too many descriptors for a box");
    Pipe log = makePipe();
    Pipe status = makePipe();
    const Descriptor filter = seccompFilter(spec.mayFork);
    const std::vector<Descriptor> entrances =
        cgroup != nullptr ? cgroup->entrances() : std::vector<Descriptor>{};
    std::vector<int> groups;
    groups.reserve(entrances.size());
    for (const Descriptor &entrance : entrances)
        groups.push_back(entrance.get());
    ChildPlan plan{};
    plan.argv = argv.data();
    plan.descriptors = spec.descriptors.data();
    plan.descriptorCount = static_cast<int>(spec.descriptors.size());
    plan.groups = groups.data();
    plan.groupCount = static_cast<int>(groups.size());
    plan.logFd = log.write.get();
    plan.statusFd = status.write.get();
    plan.filterFd = filter.get();
    plan.grader = ::getpid();
    plan.asRoot = asRoot;
    // The kernel counts processes by user, so as root each box has its own: one that starts all it
    // may takes none from the others.
    static std::atomic<unsigned> counter{0};
    constexpr uid_t kMostProcesses = 1 << 22;
    plan.user = kFirstUser + static_cast<uid_t>(::getpid()) % kMostProcesses * kBoxesAtOnce +
                counter++ % kBoxesAtOnce;
    constexpr rlim_t kOurOwn = 3; // bubblewrap twice, and its helper
    plan.processes = spec.limits.processes + kOurOwn + (asRoot ? 0 : processesOf(::geteuid()));
    // A control group counts what is in use, so that the address space, of which allocators and
    // thread stacks reserve much more, needs only a coarse bound.
    constexpr rlim_t kReservedPerUsed = 4;
    plan.addressBytes = spec.limits.memoryBytes * (cgroup != nullptr ? kReservedPerUsed : 1);
    plan.limits = &spec.limits;

    const pid_t child = startWithSharedMemory(plan);
    if (child < 0)
        throw GraderError("no process can be started: the machine has too many");
    Launched launched;
    launched.process = child;
    launched.log = std::move(log.read);
    launched.status = std::move(status.read);
    return launched;
}

} // namespace grader
