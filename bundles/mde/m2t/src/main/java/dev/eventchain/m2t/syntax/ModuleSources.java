package dev.eventchain.m2t.syntax;

import dev.eventchain.diagnostics.SourceText;
import java.util.Optional;
import java.util.function.Function;

/** Finds the modules that others import or extend. */
@FunctionalInterface
public interface ModuleSources {

  /**
   * The text of a module. Texts of one name are one module, whichever names lead to it.
   *
   * @param importing the module that names it
   * @param name the name as it is written there: {@code a::b}
   */
  Optional<SourceText> find(Syntax.Module importing, SourceText source, String name);

  /** Modules that have the same name everywhere. */
  static ModuleSources everywhere(Function<String, Optional<SourceText>> sources) {
    return (importing, source, name) -> sources.apply(name);
  }

  /** These, and others where these have none of a name. */
  default ModuleSources or(ModuleSources others) {
    return (importing, source, name) ->
        find(importing, source, name).or(() -> others.find(importing, source, name));
  }
}
