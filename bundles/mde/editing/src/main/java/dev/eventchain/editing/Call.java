package dev.eventchain.editing;

import java.util.List;

/**
 * The calls between something callable and another one.
 *
 * @param other the caller of an incoming call, or the called one of an outgoing call
 * @param places the names in the caller's text at which it calls
 */
public record Call(Item other, List<TextRange> places) {

  /**
   * Something that calls or can be called: a template, a query, a definition, an invariant.
   *
   * @param detail such as its signature; empty for none
   * @param place its whole declaration
   * @param nameRange its name, inside the place
   */
  public record Item(
      String name, String detail, ElementKind kind, FileRange place, TextRange nameRange) {}
}
