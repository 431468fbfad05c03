package dev.eventchain.cli.options;

import dev.eventchain.check.ModelFiles;
import dev.eventchain.check.ReferenceFolders;
import java.nio.file.Path;
import java.util.List;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** The metamodels of models that are not in a project. */
public final class MetamodelOptions {

  @Option(
      names = "--metamodel",
      paramLabel = "FILE|URI",
      description =
          "An Ecore metamodel of the models (default: event chains), or the nsURI of one that is"
              + " known, such as http://www.eclipse.org/uml2/5.0.0/UML; may be repeated. Models of"
              + " UML need no metamodel to be named.")
  private List<Path> metamodels = List.of();

  @Mixin private ReferenceOptions references = new ReferenceOptions();

  /** Returns the metamodels that the command line names. */
  public List<Path> metamodels() {
    return metamodels;
  }

  /** Returns the folders to which references may lead. */
  public ReferenceFolders folders() {
    return references.folders();
  }

  /** Returns models of them. */
  public ModelFiles of(List<Path> models) {
    return new ModelFiles(models, metamodels, folders());
  }
}
