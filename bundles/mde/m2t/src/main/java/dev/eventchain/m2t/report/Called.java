package dev.eventchain.m2t.report;

import dev.eventchain.m2t.syntax.Place;

/** What a run calls, as findings name it. */
public interface Called {

  /** Its name. */
  String name();

  /** Where it is declared. */
  Place place();
}
