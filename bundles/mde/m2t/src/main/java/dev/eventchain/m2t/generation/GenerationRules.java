package dev.eventchain.m2t.generation;

import dev.eventchain.diagnostics.Rule;

/** Rules of the findings about the generation of files. */
public final class GenerationRules {

  public static final Rule CONDITION = Rule.error("m2t.condition");
  public static final Rule FILE_DUPLICATE = Rule.error("m2t.file.duplicate");
  public static final Rule FILE_NO_FOLDER = Rule.error("m2t.file.no-folder");
  public static final Rule FOR_TYPE = Rule.warning("m2t.for.type");
  public static final Rule LET_KIND = Rule.warning("m2t.let.kind");
  public static final Rule PROTECTED_LOST = Rule.warning("m2t.protected.lost");
  public static final Rule RECURSION = Rule.error("m2t.recursion");
  public static final Rule SERVICE = Rule.error("m2t.service", GenerationTrait.UNDEFINED);
  public static final Rule UNDEFINED = Rule.error("m2t.undefined", GenerationTrait.UNDEFINED);

  private GenerationRules() {}
}
