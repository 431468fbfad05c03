package dev.eventchain.eclipse.ui.text;

import dev.eventchain.eclipse.ui.EventchainUi;
import java.util.Locale;

/** Kinds of tokens that have their own colour. */
public enum TokenKind {
  /** Template text that is copied unchanged. */
  TEXT,
  /** Names and operators. */
  CODE,
  KEYWORD,
  /** A class of a metamodel, or a type of OCL. */
  TYPE,
  STRING,
  NUMBER,
  COMMENT,
  /** The brackets of a template tag, with the keyword of a block or declaration. */
  TAG;

  /** Returns the identifier of its colour in the theme; empty for {@code TEXT} and {@code CODE}. */
  String color() {
    return EventchainUi.ID + ".text." + name().toLowerCase(Locale.ROOT);
  }
}
