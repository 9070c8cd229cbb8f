//! F_P_BETS; all of it is [`grafika::programs::f_p_bets`].

fn main() -> std::process::ExitCode {
    grafika::programs::f_p_bets::PROGRAM.main()
}
