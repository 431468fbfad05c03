package dev.eventchain.output;

import dev.eventchain.diagnostics.Rule;

/** Rules of the findings about written files. */
public final class OutputRules {

  public static final Rule EVENTCHAIN_FILE_EDITED = Rule.warning("eventchain.file.edited");
  public static final Rule OUTPUT_LOCKED = Rule.error("output.locked");
  public static final Rule OUTPUT_PATH_REFUSED = Rule.error("output.path.refused");
  public static final Rule OUTPUT_RECORDS_DAMAGED = Rule.warning("output.records.damaged");
  public static final Rule OUTPUT_UNWRITABLE = Rule.error("output.unwritable");

  private OutputRules() {}
}
