package dev.eventchain.m2t.syntax;

import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;

/** Words with a meaning of their own inside the tags of blocks and declarations. */
public final class Words {
  static final String AFTER = "after";
  static final String BEFORE = "before";
  static final String END_TAG_PREFIX = "endTagPrefix";
  static final String EXTENDS = "extends";
  static final String OVERRIDES = "overrides";
  static final String POST = "post";
  static final String SEPARATOR = "separator";
  static final String START_TAG_PREFIX = "startTagPrefix";
  static final String SUPER = "super";

  private Words() {}

  /** Returns all, in alphabetical order. */
  public static List<String> all() {
    return Stream.concat(
            Stream.of(
                AFTER,
                BEFORE,
                END_TAG_PREFIX,
                EXTENDS,
                OVERRIDES,
                POST,
                SEPARATOR,
                START_TAG_PREFIX,
                SUPER),
            Stream.of(Syntax.Visibility.values()).map(Words::of))
        .sorted()
        .toList();
  }

  static String of(Syntax.Visibility visibility) {
    return visibility.name().toLowerCase(Locale.ROOT);
  }
}
