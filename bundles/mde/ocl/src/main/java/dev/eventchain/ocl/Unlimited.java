package dev.eventchain.ocl;

/**
 * The UnlimitedNatural that is above all numbers, {@code *}; it is not an operand of arithmetic.
 */
enum Unlimited {
  UNLIMITED;

  @Override
  public String toString() {
    return "*";
  }
}
