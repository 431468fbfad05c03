package dev.eventchain.m2t;

import dev.eventchain.m2t.syntax.Place;

/** What a run calls, as findings name it. */
interface Called {

  /** Its name. */
  String name();

  /** Where it is declared. */
  Place place();
}
