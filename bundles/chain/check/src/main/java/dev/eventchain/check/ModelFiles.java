package dev.eventchain.check;

import java.nio.file.Path;
import java.util.List;

/**
 * Models, and what they are read with.
 *
 * @param files the models; those that they refer to in other files are read, too
 * @param metamodels their metamodels; none for event chains; UML need not be named
 * @param references where references may lead besides the folders of the files
 */
public record ModelFiles(List<Path> files, List<Path> metamodels, ReferenceFolders references) {

  /** Copies the lists. */
  public ModelFiles {
    files = List.copyOf(files);
    metamodels = List.copyOf(metamodels);
  }

  /** Returns models whose references stay in the folders of the files. */
  public static ModelFiles of(List<Path> files, List<Path> metamodels) {
    return new ModelFiles(files, metamodels, ReferenceFolders.NONE);
  }
}
