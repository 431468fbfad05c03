package dev.eventchain.pipeline.format;

import dev.eventchain.diagnostics.CommonTrait;
import dev.eventchain.diagnostics.Rule;

/** Rules of the findings about the formatting of files. */
final class FormatRules {

  static final Rule DIFFERS = Rule.error("format.differs");
  static final Rule NOTHING = Rule.error("format.nothing");
  static final Rule OUTSIDE = Rule.error("format.outside");
  static final Rule SKIPPED = Rule.warning("format.skipped");
  static final Rule SYNTAX = Rule.error("format.syntax", CommonTrait.UNSUPPRESSIBLE);
  static final Rule UNWRITABLE = Rule.error("format.unwritable");

  private FormatRules() {}
}
