package dev.eventchain.xmi;

import dev.eventchain.diagnostics.Rule;

/** Rules of the findings about what a metamodel itself demands of its models. */
final class EcoreRules {

  static final Rule BOUND = Rule.error("ecore.bound");
  static final Rule KEY = Rule.error("ecore.key");
  static final Rule LIMIT = Rule.error("ecore.limit");
  static final Rule MAP = Rule.error("ecore.map");
  static final Rule OPPOSITE = Rule.error("ecore.opposite");
  static final Rule REQUIRED = Rule.error("ecore.required");
  static final Rule UNIQUE = Rule.error("ecore.unique");
  static final Rule VALUE = Rule.error("ecore.value");

  private EcoreRules() {}
}
