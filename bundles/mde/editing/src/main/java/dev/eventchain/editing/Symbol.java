package dev.eventchain.editing;

import java.util.List;

/**
 * A named part of a text.
 *
 * @param name its name, never blank
 * @param detail such as its type or signature; empty for none
 * @param range the whole part
 * @param nameRange the name, inside the range
 * @param children the parts inside it, in the order of the text
 */
public record Symbol(
    String name,
    String detail,
    ElementKind kind,
    TextRange range,
    TextRange nameRange,
    List<Symbol> children) {}
