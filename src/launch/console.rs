//! The console that Windows opens for a program that Explorer starts.
//!
//! The executables are programs of the console, so that a shell waits for them, sees what they say and can show them in the
//! terminal. Started from Explorer, a program gets a console of its own, which would stand empty behind its window.

/// A process in the list of all.
struct Process {
    id: u32,
    parent: u32,
    /// The name of its executable.
    name: String,
}

/// Whether a process was started from the desktop and not from a shell.
fn is_from_desktop(processes: &[Process], own: u32) -> bool {
    let process = |id| processes.iter().find(|process| process.id == id);
    let parent = process(own).and_then(|own| process(own.parent));
    parent.is_some_and(|parent| parent.name.eq_ignore_ascii_case("explorer.exe"))
}

/// Lets go of the console if Explorer has opened it for this process alone. Where this cannot be found out, it stays.
#[cfg(windows)]
pub(super) fn let_go() {
    use winsafe::{FreeConsole, GetCurrentProcessId, HPROCESSLIST, co};
    let Ok(mut list) = HPROCESSLIST::CreateToolhelp32Snapshot(co::TH32CS::SNAPPROCESS, None) else { return };
    let processes = list.iter_processes().flatten().map(|process| Process {
        id: process.th32ProcessID,
        parent: process.th32ParentProcessID,
        name: process.szExeFile(),
    });
    if is_from_desktop(&processes.collect::<Vec<_>>(), GetCurrentProcessId()) {
        // Without a console there is none to let go.
        let _ = FreeConsole();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn explorer_is_the_desktop_and_a_shell_is_not() {
        let process = |id, parent, name: &str| Process { id, parent, name: name.to_owned() };
        let list = [
            process(4, 0, "System"),
            process(20, 4, "Explorer.EXE"),
            process(21, 20, "cmd.exe"),
            process(30, 20, "grafika.exe"),
            process(31, 21, "grafika.exe"),
            process(32, 99, "grafika.exe"),
        ];
        assert!(is_from_desktop(&list, 30));
        // From a console that Explorer started, from a parent that is gone, and not in the list.
        assert!(![31, 32, 33].into_iter().any(|own| is_from_desktop(&list, own)));
    }
}
