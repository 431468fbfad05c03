package dev.eventchain.project.requirements;

import dev.eventchain.diagnostics.SourceLocation;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/**
 * A file or folder of requirements that a project names, with the choice of its items.
 *
 * @param file the file or folder
 * @param project the folder of the project, in which texts of the source may name further files
 * @param only the items that count
 * @param fields the names of the fields that hold what is read
 * @param place where the project names it
 */
public record RequirementSource(
    Path file, Path project, Only only, Fields fields, SourceLocation place) {

  /**
   * The items that count: those with one of the types, one of the statuses and one of the tags. An
   * empty list stands for any.
   */
  public record Only(List<String> types, List<String> statuses, List<String> tags) {

    /** All items. */
    public static final Only ALL = new Only(List.of(), List.of(), List.of());

    /** Copies the lists. */
    public Only {
      types = List.copyOf(types);
      statuses = List.copyOf(statuses);
      tags = List.copyOf(tags);
    }
  }

  /**
   * Names of fields; an empty one stands for the usual fields of the format.
   *
   * @param id of the id
   * @param text of the text
   * @param status of the status
   * @param tags of the tags
   * @param parents of the links to parents; in ReqIF, names of relation types
   */
  public record Fields(
      Optional<String> id,
      Optional<String> text,
      Optional<String> status,
      Optional<String> tags,
      List<String> parents) {

    /** The usual fields of each format. */
    public static final Fields USUAL =
        new Fields(
            Optional.empty(), Optional.empty(), Optional.empty(), Optional.empty(), List.of());

    /** Copies the list. */
    public Fields {
      parents = List.copyOf(parents);
    }
  }
}
