package dev.eventchain.catalogue.signal;

import dev.eventchain.diagnostics.Rule;

/** Rules of the findings about catalogues of signals. */
public final class CatalogueRules {

  public static final Rule ATTRIBUTE = Rule.warning("catalogue.attribute");
  public static final Rule EMPTY = Rule.error("catalogue.empty");
  public static final Rule ENTRY = Rule.error("catalogue.entry");
  public static final Rule FORMAT = Rule.error("catalogue.format");
  public static final Rule INCLUDE = Rule.error("catalogue.include");
  public static final Rule OVERLAY = Rule.error("catalogue.overlay");
  public static final Rule SIZE = Rule.error("catalogue.size");

  private CatalogueRules() {}
}
