package dev.eventchain.eclipse.ui.text;

import java.util.List;
import java.util.Set;

/** The two languages, with how their texts are divided into partitions. */
enum Language {
  OCL,
  TEMPLATE;

  /** The partitioning of their documents. */
  static final String PARTITIONING = "dev.eventchain.eclipse.ui.text";

  /** The type of partitions that are comments. */
  static final String COMMENT = PARTITIONING + ".comment";

  /** The type of partitions that are tags of a template. */
  static final String TAG = PARTITIONING + ".tag";

  /** The parts of a text that are separate partitions; all else is code or plain text. */
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
