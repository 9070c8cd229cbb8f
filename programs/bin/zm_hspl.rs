//! ZM_HSPL; all of it is [`grafika::programs::zm_hspl`].

fn main() -> std::process::ExitCode {
    grafika::programs::zm_hspl::PROGRAM.main()
}
