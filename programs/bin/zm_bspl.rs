//! ZM_BSPL; all of it is [`grafika::programs::zm_bspl`].

fn main() -> std::process::ExitCode {
    grafika::programs::zm_bspl::PROGRAM.main()
}
