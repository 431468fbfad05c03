package dev.eventchain.editing;

/**
 * Description of the word at a position.
 *
 * @param markdown the text in Markdown
 * @param range the word that it is about
 */
public record Hover(String markdown, TextRange range) {}
