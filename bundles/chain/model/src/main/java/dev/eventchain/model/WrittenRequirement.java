package dev.eventchain.model;

import dev.eventchain.diagnostics.SourceLocation;
import java.util.List;
import java.util.Optional;

/**
 * A requirement or a design rule as written by users, independent of the chain that satisfies it.
 *
 * @param id the id
 * @param text the text, on one line
 * @param location the location of its text
 * @param details what else its source says about it
 */
public record WrittenRequirement(String id, String text, SourceLocation location, Details details) {

  /** Creates a requirement of which the source says nothing else. */
  public WrittenRequirement(String id, String text, SourceLocation location) {
    this(id, text, location, Details.NONE);
  }

  /**
   * Attributes of a requirement in tools for requirements besides its text.
   *
   * @param type the type, such as the tag of a node or the prefix of a document
   * @param status the status
   * @param tags the tags, in the order of the source
   * @param parents the requirements from which it is derived, in the order of the source
   */
  public record Details(
      Optional<String> type, Optional<String> status, List<String> tags, List<Parent> parents) {

    /** Nothing. */
    public static final Details NONE =
        new Details(Optional.empty(), Optional.empty(), List.of(), List.of());

    /** Copies the lists. */
    public Details {
      tags = List.copyOf(tags);
      parents = List.copyOf(parents);
    }
  }

  /**
   * A requirement from which another one is derived.
   *
   * @param id its id, which need not be known
   * @param location the place that names it
   */
  public record Parent(String id, SourceLocation location) {}

  /** Returns the ids of its parents, each once. */
  public List<String> parentIds() {
    return details.parents().stream().map(Parent::id).distinct().toList();
  }
}
