package dev.eventchain.editing;

/**
 * A text that an editor shows at a position although it is not written there.
 *
 * @param text such as {@code : Sequence(Node)}
 */
public record InlayHint(TextPosition position, String text) {}
