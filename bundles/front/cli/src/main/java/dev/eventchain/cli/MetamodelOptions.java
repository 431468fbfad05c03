package dev.eventchain.cli;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
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

  @Option(
      names = "--map",
      paramLabel = "URI=FOLDER|FILE",
      description =
          "Where to find the files that references name by a URI with this prefix, for example"
              + " platform:/resource/=workspace/, or which file a full URI means. May be repeated."
              + " Other references are followed into the folders of the files that the command"
              + " names, and into these.")
  Map<String, Path> map = Map.of();
}
