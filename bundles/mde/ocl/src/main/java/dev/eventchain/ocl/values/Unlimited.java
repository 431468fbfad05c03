package dev.eventchain.ocl.values;

/**
 * The UnlimitedNatural that is above all numbers, {@code *}; it is not an operand of arithmetic.
 */
public enum Unlimited {
  UNLIMITED;

  @Override
  public String toString() {
    return "*";
  }
}
