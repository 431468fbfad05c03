package dev.eventchain.editing;

/**
 * A proposed completion of the text at a position.
 *
 * @param label what a list of proposals shows; also what the typed prefix is compared with
 * @param detail such as its type or signature; empty for none
 * @param documentation in Markdown; empty for none
 * @param insertText the text that replaces the range
 * @param snippet true if the text has places to fill in, in the syntax of the Language Server
 *     Protocol: {@code $1}, <code>${1:name}</code>, {@code $0}
 * @param replaced the typed prefix that is replaced, on one line; it ends at the position or,
 *     inside a word, after it
 */
public record Completion(
    String label,
    ElementKind kind,
    String detail,
    String documentation,
    String insertText,
    boolean snippet,
    TextRange replaced) {}
