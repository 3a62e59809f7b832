// SPDX-License-Identifier: MIT
#include "seccomp_filter.h"

#include <grader/error.h>

#include <seccomp.h>

#include <fcntl.h>
#include <sched.h>
#include <sys/mman.h>

#include <cerrno>
#include <memory>

namespace grader {

namespace {

/// What neither a compiler nor a renderer needs; refused with EPERM. The namespaces already hold
/// most of it: this is the second wall, and keeps the kernel's newer corners out of reach.
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
                                   "io_uring_setup",
                                   "io_uring_enter",
                                   "io_uring_register",
                                   "userfaultfd",
                                   "keyctl",
                                   "add_key",
                                   "request_key",
                                   "memfd_create",
                                   "memfd_secret",
                                   "kexec_load",
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
                                   "vmsplice"};

constexpr const char *kDeniedToProbes[] = {"fork", "vfork", "execveat"};

struct ReleaseFilter {
    void operator()(void *filter) const { seccomp_release(filter); }
};

void deny(scmp_filter_ctx filter, const char *name) {
    const int number = seccomp_syscall_resolve_name(name);
    if (number == __NR_SCMP_ERROR)
        return; // this machine has no such call
    if (seccomp_rule_add(filter, SCMP_ACT_ERRNO(EPERM), number, 0) != 0)
        throw GraderError(std::string("seccomp: the call ") + name + " cannot be denied");
}

} // namespace

Descriptor seccompFilter(bool mayFork) {
    const std::unique_ptr<void, ReleaseFilter> filter(seccomp_init(SCMP_ACT_ALLOW));
    if (filter == nullptr)
        throw GraderError("seccomp: no filter can be made");
    for (const char *name : kDenied)
        deny(filter.get(), name);
    if (!mayFork) {
        for (const char *name : kDeniedToProbes)
            deny(filter.get(), name);
        // Threads come from clone() with CLONE_THREAD; the C library falls back to it from
        // clone3(), whose flags a filter cannot see.
        seccomp_rule_add(filter.get(), SCMP_ACT_ERRNO(ENOSYS), SCMP_SYS(clone3), 0);
        seccomp_rule_add(filter.get(), SCMP_ACT_ERRNO(EPERM), SCMP_SYS(clone), 1,
                         SCMP_A0(SCMP_CMP_MASKED_EQ, CLONE_THREAD, 0));
    }
    Descriptor file(::memfd_create("seccomp", MFD_CLOEXEC));
    if (!file || seccomp_export_bpf(filter.get(), file.get()) != 0)
        throw GraderError("seccomp: the filter cannot be written");
    ::lseek(file.get(), 0, SEEK_SET);
    return file;
}

} // namespace grader
