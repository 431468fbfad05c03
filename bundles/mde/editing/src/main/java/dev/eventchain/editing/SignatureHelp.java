package dev.eventchain.editing;

import java.util.List;

/**
 * The signatures that a call at a position may have.
 *
 * @param signatures at least one, the most suitable first
 * @param activeParameter the index of the argument at the position; may exceed the parameters
 */
public record SignatureHelp(List<Signature> signatures, int activeParameter) {

  /**
   * A signature.
   *
   * @param label the whole signature: {@code name(first : Type, second : Type) : Type}
   * @param documentation in Markdown; empty for none
   * @param parameters the texts of the parameters, each a part of the label
   */
  public record Signature(String label, String documentation, List<String> parameters) {}
}
