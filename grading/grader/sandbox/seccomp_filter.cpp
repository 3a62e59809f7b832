// SPDX-License-Identifier: MIT
#include "seccomp_filter.h"

#include <grader/error.h>

#include <fmt/core.h>
#include <seccomp.h>

#include <fcntl.h>
#include <sched.h>
#include <sys/mman.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <memory>
#include <vector>

namespace grader {

namespace {

/// What neither a compiler nor a renderer needs; refused with EPERM. The namespaces already hold
/// most of it: this is the second wall, and keeps the kernel's newer corners out of reach. Memory
/// that belongs to no process (System V, memfd) would escape the limits where there is no control
/// group. A box that gives up its own priority would look starved by others (endOfTime()).
constexpr const char *kDenied[] = {"socket",
                                   "socketpair",
                                   "connect",
                                   "bind",
                                   "listen",
                                   "accept",
                                   "accept4",
                                   "ptrace",
                                   "process_vm_readv",
                                   "process_vm_writev",
                                   "process_madvise",
                                   "kcmp",
                                   "unshare",
                                   "setns",
                                   "mount",
                                   "umount2",
                                   "pivot_root",
                                   "chroot",
                                   "move_mount",
                                   "open_tree",
                                   "fsopen",
                                   "fsmount",
                                   "fsconfig",
                                   "fspick",
                                   "mount_setattr",
                                   "bpf",
                                   "perf_event_open",
                                   "io_setup",
                                   "io_uring_setup",
                                   "io_uring_enter",
                                   "io_uring_register",
                                   "userfaultfd",
                                   "keyctl",
                                   "add_key",
                                   "request_key",
                                   "memfd_create",
                                   "shmget",
                                   "shmat",
                                   "msgget",
                                   "semget",
                                   "mq_open",
                                   "memfd_secret",
                                   "kexec_load",
                                   "kexec_file_load",
                                   "fanotify_init",
                                   "init_module",
                                   "finit_module",
                                   "delete_module",
                                   "reboot",
                                   "swapon",
                                   "swapoff",
                                   "settimeofday",
                                   "clock_settime",
                                   "adjtimex",
                                   "quotactl",
                                   "acct",
                                   "syslog",
                                   "personality",
                                   "modify_ldt",
                                   "open_by_handle_at",
                                   "name_to_handle_at",
                                   "landlock_create_ruleset",
                                   "pidfd_getfd",
                                   "vmsplice",
                                   "sched_setscheduler",
                                   "sched_setparam",
                                   "sched_setattr",
                                   "sched_setaffinity",
                                   "setpriority",
                                   "ioprio_set"};

constexpr const char *kDeniedToProbes[] = {"fork", "vfork", "execveat"};

struct ReleaseFilter {
    void operator()(void *filter) const { seccomp_release(filter); }
};

constexpr std::array<scmp_datum_t, 7> kNamespaceFlags = {
    CLONE_NEWNS,   CLONE_NEWCGROUP, CLONE_NEWUTS, CLONE_NEWIPC,
    CLONE_NEWUSER, CLONE_NEWPID,    CLONE_NEWNET};

/// Refuses a call, if its arguments compare so.
void addRule(scmp_filter_ctx filter, std::uint16_t error, int call,
             const std::vector<scmp_arg_cmp> &comparisons = {}) {
    if (seccomp_rule_add_array(filter, SCMP_ACT_ERRNO(error), call,
                               static_cast<unsigned>(comparisons.size()), comparisons.data()) != 0)
        throw GraderError(fmt::format("seccomp: call {} cannot be denied", call));
}

void deny(scmp_filter_ctx filter, const char *name) {
    const int number = seccomp_syscall_resolve_name(name);
    if (number != __NR_SCMP_ERROR) // else this machine has no such call
        addRule(filter, EPERM, number);
}

} // namespace

Descriptor seccompFilter(bool mayFork) {
    const std::unique_ptr<void, ReleaseFilter> filter(seccomp_init(SCMP_ACT_ALLOW));
    if (filter == nullptr)
        throw GraderError("seccomp: no filter can be made");
    for (const char *name : kDenied)
        deny(filter.get(), name);
    // clone3()'s flags are behind a pointer, where a filter cannot see them; the C library falls
    // back to clone().
    addRule(filter.get(), ENOSYS, SCMP_SYS(clone3));
    for (const scmp_datum_t flag : kNamespaceFlags)
        addRule(filter.get(), EPERM, SCMP_SYS(clone), {SCMP_A0(SCMP_CMP_MASKED_EQ, flag, flag)});
    // Of others: the first process of the box would die of a limit, and its end look like ours.
    addRule(filter.get(), EPERM, SCMP_SYS(prlimit64), {SCMP_A0(SCMP_CMP_NE, 0)});
    if (!mayFork) {
        for (const char *name : kDeniedToProbes)
            deny(filter.get(), name);
        // Threads only.
        addRule(filter.get(), EPERM, SCMP_SYS(clone),
                {SCMP_A0(SCMP_CMP_MASKED_EQ, CLONE_THREAD, 0)});
    }
    Descriptor file(::memfd_create("seccomp", MFD_CLOEXEC));
    if (!file || seccomp_export_bpf(filter.get(), file.get()) != 0)
        throw GraderError("seccomp: the filter cannot be written");
    ::lseek(file.get(), 0, SEEK_SET);
    return file;
}

} // namespace grader
