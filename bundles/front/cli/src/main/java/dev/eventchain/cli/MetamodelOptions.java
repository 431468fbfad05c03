package dev.eventchain.cli;

import dev.eventchain.check.ModelFiles;
import java.nio.file.Path;
import java.util.List;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** The metamodels of models that are not in a project. */
final class MetamodelOptions {

  @Option(
      names = "--metamodel",
      paramLabel = "FILE|URI",
      description =
          "An Ecore metamodel of the models (default: event chains), or the nsURI of one that is"
              + " known, such as http://www.eclipse.org/uml2/5.0.0/UML; may be repeated. Models of"
              + " UML need no metamodel to be named.")
  List<Path> metamodels = List.of();

  @Mixin ReferenceOptions references = new ReferenceOptions();

  /** Returns models of them. */
  ModelFiles of(List<Path> models) {
    return new ModelFiles(models, metamodels, references.folders());
  }
}
