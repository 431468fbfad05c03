package dev.eventchain.eclipse.ui.text;

import java.util.List;
import java.util.Set;

/** The two languages, with the partitioning of their documents. */
enum Language {
  OCL,
  TEMPLATE;

  /** Partitioning of their documents. */
  static final String PARTITIONING = "dev.eventchain.eclipse.ui.text";

  /** Partition type of comments. */
  static final String COMMENT = PARTITIONING + ".comment";

  /** Partition type of template tags. */
  static final String TAG = PARTITIONING + ".tag";

  /** Returns the separate partitions of a text; the rest is code or plain text. */
  List<Token> parts(String text) {
    if (this == TEMPLATE) {
      return TemplateTokens.parts(text).stream()
          .filter(part -> part.kind() != TokenKind.TEXT)
          .toList();
    }
    return OclTokens.of(text, Set.of()).stream()
        .filter(token -> token.kind() == TokenKind.COMMENT)
        .toList();
  }
}
