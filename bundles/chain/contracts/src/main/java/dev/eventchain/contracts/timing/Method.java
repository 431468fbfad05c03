package dev.eventchain.contracts.timing;

/** Published bounds, each with what it assumes. */
public enum Method {
  /** Exact for logical execution times; A. Hamann et al., ECRTS 2017, give the sum of periods. */
  LET(
      "exact for logical execution times with these phases and messages that take their longest times"),
  /** A. Davare et al., DAC 2007. */
  DAVARE("Davare et al. 2007: any phases, each worst-case response time holds"),
  /** M. Dürr et al., ACM TECS 2019. */
  DUERR("Dürr et al. 2019: any phases, fixed priorities, preemption on each processor"),
  /** T. Kloda et al., ETFA 2018. */
  KLODA("Kloda et al. 2018: these phases of one clock, fixed priorities, preemption");

  private final String assumption;

  Method(String assumption) {
    this.assumption = assumption;
  }

  /** Returns the source of the bound and what it assumes, for users. */
  public String assumption() {
    return assumption;
  }
}
