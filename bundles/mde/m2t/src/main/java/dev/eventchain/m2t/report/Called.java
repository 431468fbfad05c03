package dev.eventchain.m2t.report;

import dev.eventchain.m2t.syntax.Place;

/** A callable as named in findings. */
public interface Called {

  /** Returns the name. */
  String name();

  /** Returns the place of the declaration. */
  Place place();
}
