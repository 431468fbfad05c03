package dev.eventchain.pipeline;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Random;
import java.util.TreeMap;

/**
 * A metamodel of three packages in two files that refer to each other: {@code a}, {@code a::sub}
 * and {@code b}. Constraints and bodies are in the metamodel or in a document.
 */
final class PlantedMetamodel {

  static final List<String> PACKAGES = List.of("a", "a::sub", "b");
  static final Map<String, String> NAMESPACES =
      Map.of("a", "http://p.org/a", "sub", "http://p.org/sub", "b", "http://p.org/b");

  /** A class or an enumeration, in one of the packages. */
  record Type(String inPackage, String name) {

    String inOcl() {
      return inPackage + "::" + name;
    }

    String inXmi() {
      return inPackage.replaceFirst(".*::", "") + ":" + name;
    }

    private String from(String other) {
      String file = inPackage.charAt(0) == other.charAt(0) ? "" : inPackage.charAt(0) + ".ecore";
      return file + "#//" + (inPackage.endsWith("sub") ? "sub/" : "") + name;
    }
  }

  static final Type BASE = new Type("a", "Base");
  static final Type TARGET = new Type("a", "Target");
  static final Type SPECIAL = new Type("b", "Special");
  static final Type COLOUR = new Type("a::sub", "Colour");
  static final List<String> COLOURS = List.of("RED", "GREEN", "BLUE");

  private static final String ECORE = "http://www.eclipse.org/emf/2002/Ecore";

  private final Random random;
  private final Map<Type, String> heads = new LinkedHashMap<>();
  private final Map<Type, StringBuilder> features = new LinkedHashMap<>();
  private final StringBuilder document = new StringBuilder();
  private int rules;

  PlantedMetamodel(Random random) {
    this.random = random;
    declare(BASE, "abstract=\"true\"");
    add(BASE, "EAttribute", "name", data("EString") + " iD=\"true\"", "");
    Type root = new Type("a", "Root");
    declare(root, "");
    reference(root, "all", BASE, "upperBound=\"-1\" containment=\"true\"");
    declare(TARGET, supers(TARGET, BASE));
    add(TARGET, "EAttribute", "mark", data("EInt"), "");
    attribute(TARGET, "colour", COLOUR, "");
    declare(SPECIAL, supers(SPECIAL, TARGET));
  }

  private void declare(Type type, String attributes) {
    heads.put(type, attributes);
    features.put(type, new StringBuilder());
  }

  private static String supers(Type type, Type above) {
    return "eSuperTypes=\"" + above.from(type.inPackage()) + "\"";
  }

  /** Returns a new class in any of the packages. */
  Type type(Type above, boolean isAbstract) {
    String inPackage = PACKAGES.get(random.nextInt(PACKAGES.size()));
    Type type = new Type(inPackage, "E" + heads.size());
    declare(type, supers(type, above) + (isAbstract ? " abstract=\"true\"" : ""));
    return type;
  }

  static String data(String name) {
    return "eType=\"ecore:EDataType " + ECORE + "#//" + name + "\"";
  }

  /** Returns the text escaped for a text attribute of XML. */
  static String escaped(String text) {
    return text.replace("&", "&amp;").replace("<", "&lt;").replace("\"", "&quot;");
  }

  static String annotation(String source, String... details) {
    StringBuilder text = new StringBuilder("<eAnnotations source=\"" + source + "\">");
    for (int i = 0; i < details.length; i += 2) {
      text.append("<details key=\"%s\" value=\"%s\"/>".formatted(details[i], details[i + 1]));
    }
    return text.append("</eAnnotations>").toString();
  }

  private static String ocl(String key, String expression) {
    return annotation(ECORE + "/OCL", key, escaped(expression));
  }

  void attribute(Type owner, String name, String dataType, String more) {
    add(owner, "EAttribute", name, data(dataType) + " " + more, "");
  }

  void attribute(Type owner, String name, Type enumeration, String more) {
    String type = "eType=\"ecore:EEnum " + enumeration.from(owner.inPackage()) + "\" ";
    add(owner, "EAttribute", name, type + more, "");
  }

  void reference(Type owner, String name, Type to, String more) {
    add(owner, "EReference", name, toClass(owner, to) + more, "");
  }

  private static String toClass(Type owner, Type to) {
    return "eType=\"ecore:EClass " + to.from(owner.inPackage()) + "\" ";
  }

  /** Returns the end of a bidirectional reference. */
  static String opposite(Type owner, Type to, String name) {
    return "eOpposite=\"" + to.from(owner.inPackage()) + "/" + name + "\" ";
  }

  /** Adds a feature map, whose members another call adds. */
  void featureMap(Type owner, String name) {
    String more = data("EFeatureMapEntry") + " upperBound=\"-1\"";
    add(owner, "EAttribute", name, more, extended("kind", "group", "name", name + ":0"));
  }

  void memberOfMap(Type owner, String map, String name, Type to, String more) {
    String shape = "volatile=\"true\" transient=\"true\" derived=\"true\" " + more;
    String text = extended("kind", "element", "name", name, "group", "#" + map + ":0");
    if (to == null) {
      add(owner, "EAttribute", name, data("EString") + " " + shape, text);
    } else {
      add(owner, "EReference", name, toClass(owner, to) + shape, text);
    }
  }

  private static String extended(String... details) {
    return annotation("http:///org/eclipse/emf/ecore/util/ExtendedMetaData", details);
  }

  /** Adds a derived feature; {@code to} is null for an Integer. */
  void derived(Type owner, String name, Type to, String more, String expression) {
    boolean inDocument = random.nextBoolean();
    if (inDocument) {
      String type = to == null ? "Integer" : "Set(" + to.inOcl() + ")";
      document.append(
          "context %s::%s : %s derive: %s\n".formatted(owner.inOcl(), name, type, expression));
    }
    String shape = "derived=\"true\" volatile=\"true\" transient=\"true\" changeable=\"false\" ";
    add(
        owner,
        to == null ? "EAttribute" : "EReference",
        name,
        shape + (to == null ? data("EInt") : toClass(owner, to)) + more,
        inDocument ? "" : ocl("derivation", expression));
  }

  /** Adds an operation without parameters that returns an Integer. */
  void operation(Type owner, String name, String expression) {
    boolean inDocument = random.nextBoolean();
    if (inDocument) {
      document.append(
          "context %s::%s() : Integer body: %s\n".formatted(owner.inOcl(), name, expression));
    }
    features
        .get(owner)
        .append("<eOperations name=\"%s\" %s>".formatted(name, data("EInt")))
        .append(inDocument ? "" : ocl("body", expression))
        .append("</eOperations>\n");
  }

  private void add(Type owner, String kind, String name, String more, String annotations) {
    features
        .get(owner)
        .append("<eStructuralFeatures xsi:type=\"ecore:%s\" name=\"%s\" ".formatted(kind, name))
        .append(more + ">" + annotations + "</eStructuralFeatures>\n");
  }

  /** Adds an invariant, in the metamodel or in the document, and returns its name in findings. */
  String rule(Type context, String expression) {
    rules++;
    String name = "P" + rules;
    if (random.nextBoolean()) {
      features.get(context).insert(0, ocl(name, expression) + "\n");
    } else {
      document.append("context %s inv %s: %s\n".formatted(context.inOcl(), name, expression));
    }
    return context.name() + "::" + name;
  }

  String document() {
    return document.toString();
  }

  /** Returns the text of each file, by its name. */
  Map<String, String> files() {
    Map<String, String> files = new TreeMap<>();
    files.put("a.ecore", file("a", openPackage("a::sub") + enumeration() + "</eSubpackages>\n"));
    files.put("b.ecore", file("b", ""));
    return files;
  }

  private String file(String name, String more) {
    String open = "<ecore:EPackage xmi:version=\"2.0\" xmlns:xmi=\"http://www.omg.org/XMI\"";
    open += " xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\" xmlns:ecore=\"" + ECORE;
    open += "\" " + named(name) + ">\n";
    return open + classes(name) + more + "</ecore:EPackage>\n";
  }

  private static String named(String name) {
    String text = "name=\"%s\" nsPrefix=\"%s\" nsURI=\"%s\"";
    return text.formatted(name, name, NAMESPACES.get(name));
  }

  private String openPackage(String name) {
    return "<eSubpackages " + named("sub") + ">\n" + classes(name);
  }

  private static String enumeration() {
    StringBuilder text =
        new StringBuilder("<eClassifiers xsi:type=\"ecore:EEnum\" name=\"Colour\">");
    for (int i = 0; i < COLOURS.size(); i++) {
      text.append(
          String.format(Locale.ROOT, "<eLiterals name=\"%s\" value=\"%d\"/>", COLOURS.get(i), i));
    }
    return text.append("</eClassifiers>\n").toString();
  }

  private String classes(String inPackage) {
    StringBuilder text = new StringBuilder();
    heads.forEach(
        (type, head) -> {
          if (type.inPackage().equals(inPackage)) {
            text.append(
                    "<eClassifiers xsi:type=\"ecore:EClass\" name=\"%s\" ".formatted(type.name()))
                .append(head + ">\n" + features.get(type) + "</eClassifiers>\n");
          }
        });
    return text.toString();
  }
}
