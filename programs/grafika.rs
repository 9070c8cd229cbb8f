//! `grafika`: the menu and the command line over all programs.

mod gb_2d_ip;

fn main() -> std::process::ExitCode {
    gb_2d_ip::PROGRAM.main()
}
