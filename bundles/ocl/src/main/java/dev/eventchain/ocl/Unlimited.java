package dev.eventchain.ocl;

/** The UnlimitedNatural that is above all numbers, {@code *}; it is no operand of arithmetic. */
enum Unlimited {
  UNLIMITED;

  @Override
  public String toString() {
    return "*";
  }
}
