package dev.eventchain.m2t.syntax;

import dev.eventchain.diagnostics.SourceText;
import java.util.Optional;
import java.util.function.Function;

/** Resolver of the modules that others import or extend. */
@FunctionalInterface
public interface ModuleSources {

  /**
   * Returns the text of a module. Texts with equal names are one module, even if found by different
   * names.
   *
   * @param importing the importing module
   * @param name the name as written there: {@code a::b}
   */
  Optional<SourceText> find(Syntax.Module importing, SourceText source, String name);

  /** Returns a resolver in which names do not depend on the importing module. */
  static ModuleSources everywhere(Function<String, Optional<SourceText>> sources) {
    return (importing, source, name) -> sources.apply(name);
  }

  /** Returns a resolver that falls back to another one. */
  default ModuleSources or(ModuleSources others) {
    return (importing, source, name) ->
        find(importing, source, name).or(() -> others.find(importing, source, name));
  }
}
