package dev.eventchain.pipeline;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Random;

/** A metamodel, constraints, models that refer to each other, and the expected findings. */
final class PlantedFiles {

  private final Random random;
  private final PlantedMetamodel metamodel;
  private final Map<String, String> metamodelFiles;
  private final List<List<PlantedElement>> models = new ArrayList<>();
  private final List<List<String>> lines = new ArrayList<>();
  private final List<String> expected = new ArrayList<>();

  PlantedFiles(long seed) {
    random = new Random(seed);
    metamodel = new PlantedMetamodel(random);
    int files = 1 + random.nextInt(3);
    for (int i = 0; i < files; i++) {
      models.add(new ArrayList<>());
    }
    Plants plants = new Plants(metamodel, random);
    for (int i = 1 + random.nextInt(5); i > 0; i--) {
      plants.plant();
    }
    metamodelFiles = metamodel.files();
    distribute(plants.elements());
  }

  /** Distributes elements over the files, and writes these. */
  private void distribute(List<PlantedElement> elements) {
    for (int i = 0; i < elements.size(); i++) {
      int file = random.nextInt(models.size());
      models.get(file).add(elements.get(i));
      elements.get(i).place(nameOf(file), "n" + i);
    }
    for (List<PlantedElement> model : models) {
      List<String> text = new ArrayList<>();
      text.add("<a:Root xmi:version=\"2.0\" xmlns:xmi=\"http://www.omg.org/XMI\"" + namespaces());
      model.forEach(element -> element.write("all", text, expected));
      text.add("</a:Root>");
      lines.add(text);
    }
    expected.sort(null);
  }

  private static String nameOf(int file) {
    return "m" + file + ".xmi";
  }

  private static String namespaces() {
    StringBuilder text =
        new StringBuilder(" xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\"");
    for (String prefix : List.of("a", "sub", "b")) {
      text.append(" xmlns:" + prefix + "=\"" + PlantedMetamodel.NAMESPACES.get(prefix) + "\"");
    }
    return text.append('>').toString();
  }

  /** Returns the expected findings: file, line and rule, or the identifier if there is no rule. */
  List<String> expected() {
    return expected;
  }

  List<Path> metamodels(Path folder) {
    return List.of(folder.resolve("a.ecore"), folder.resolve("b.ecore"));
  }

  List<Path> documents(Path folder) {
    return metamodel.document().isEmpty() ? List.of() : List.of(folder.resolve("r.ocl"));
  }

  List<Path> models(Path folder) {
    List<Path> files = new ArrayList<>();
    for (int i = 0; i < models.size(); i++) {
      files.add(folder.resolve(nameOf(i)));
    }
    return files;
  }

  void write(Path folder) throws IOException {
    for (Map.Entry<String, String> file : metamodelFiles.entrySet()) {
      Files.writeString(folder.resolve(file.getKey()), file.getValue());
    }
    Files.writeString(folder.resolve("r.ocl"), metamodel.document());
    for (int i = 0; i < lines.size(); i++) {
      Files.write(folder.resolve(nameOf(i)), lines.get(i));
    }
  }

  /** Returns all files, for the analysis of failures. */
  @Override
  public String toString() {
    StringBuilder text = new StringBuilder(metamodel.document());
    metamodelFiles.values().forEach(text::append);
    lines.forEach(model -> text.append(String.join("\n", model)).append('\n'));
    return text.toString();
  }
}
