package dev.eventchain.diagnostics;

import java.util.Collection;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;

/**
 * Kind of finding: the facts that all findings of one id share. A rule is a constant in the package
 * that reports its findings, and the only owner of these facts; a page in the bundle's folder
 * {@code rules} explains it to users.
 *
 * @param id the stable dotted id, {@code ocl.violated}
 * @param severity the severity of its findings, where nothing else is said
 * @param traits what callers need to know about its findings besides
 */
public record Rule(String id, Severity severity, Set<Trait> traits) {

  /**
   * A property of rules. Bundles declare their own as enums, beside the code that asks for them, so
   * that nobody keeps a list of ids.
   */
  public interface Trait {}

  /** Refuses nulls. */
  public Rule {
    Objects.requireNonNull(id);
    Objects.requireNonNull(severity);
    traits = Set.copyOf(traits);
  }

  /** Returns a rule whose findings make a command fail. */
  public static Rule error(String id, Trait... traits) {
    return new Rule(id, Severity.ERROR, Set.of(traits));
  }

  /** Returns a rule whose findings need attention. */
  public static Rule warning(String id, Trait... traits) {
    return new Rule(id, Severity.WARNING, Set.of(traits));
  }

  /** Returns a rule with informational findings. */
  public static Rule info(String id, Trait... traits) {
    return new Rule(id, Severity.INFO, Set.of(traits));
  }

  /**
   * Returns the rule of an id among some.
   *
   * @param rules the rules of another program, whose findings come as text
   */
  public static Optional<Rule> find(String id, Collection<Rule> rules) {
    return rules.stream().filter(rule -> rule.id.equals(id)).findFirst();
  }

  /** Returns whether the findings have a property. */
  public boolean has(Trait trait) {
    return traits.contains(trait);
  }

  /** Returns the id. */
  @Override
  public String toString() {
    return id;
  }
}
