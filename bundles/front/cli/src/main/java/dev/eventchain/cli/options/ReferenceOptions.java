package dev.eventchain.cli.options;

import dev.eventchain.check.ReferenceFolders;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import picocli.CommandLine.Option;

/** Options for the folders to which references between files may lead. */
public final class ReferenceOptions {

  @Option(
      names = "--map",
      paramLabel = "URI=FOLDER|FILE",
      description =
          "Where to find the files that references name by a URI with this prefix, for example"
              + " platform:/resource/=workspace/, or which file a full URI means. May be repeated."
              + " Other references are followed into the folders of the files that the command"
              + " names, and into these.")
  private Map<String, Path> map = Map.of();

  @Option(
      names = "--root",
      paramLabel = "DIR",
      description =
          "A folder, such as a workspace or a repository, below which references may lead anywhere;"
              + " may be repeated.")
  private List<Path> roots = List.of();

  /** Returns the folders. */
  public ReferenceFolders folders() {
    return new ReferenceFolders(roots, map);
  }
}
