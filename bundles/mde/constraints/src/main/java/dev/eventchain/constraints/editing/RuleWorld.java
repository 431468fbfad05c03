package dev.eventchain.constraints.editing;

import dev.eventchain.constraints.document.Contexts;
import dev.eventchain.constraints.document.ResolvedClause;
import dev.eventchain.constraints.document.RuleDocument;
import dev.eventchain.ocl.Definitions;
import dev.eventchain.ocl.ExpressionLanguage;
import dev.eventchain.ocl.metamodel.Names;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.Collectors;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EPackage;

/**
 * The language that documents share which are checked together: their definitions are known in all
 * of them. It stays the same until the signature of a definition changes.
 */
final class RuleWorld {

  /**
   * A definition: the document, its number among the definitions there, and the class that it
   * extends.
   */
  record Definition(Path file, int number, EClassifier owner) {}

  private final ExpressionLanguage language;
  private final List<EPackage> metamodels;
  private final List<String> signatures;
  private final IdentityHashMap<Object, Definition> definitions = new IdentityHashMap<>();
  private final Map<String, Object> features = new HashMap<>();

  /** The definitions of each class by name and parameters; several ones are equal, or a fault. */
  private final Map<String, List<Definition>> named = new HashMap<>();

  private final Map<Definition, String> names = new HashMap<>();

  RuleWorld(List<EPackage> metamodels, List<RuleText> texts) {
    this.language = ExpressionLanguage.of(metamodels);
    this.metamodels = metamodels;
    this.signatures = signatures(texts);
    Contexts contexts = new Contexts(language.packages(), new ArrayList<>());
    IdentityHashMap<Definitions.Definition, Definition> places = new IdentityHashMap<>();
    List<Definitions.Definition> all = new ArrayList<>();
    for (RuleText text : texts) {
      List<RuleDocument.Clause> clauses = text.definitions();
      for (int i = 0; i < clauses.size(); i++) {
        Optional<ResolvedClause> resolved = contexts.resolve(clauses.get(i));
        if (resolved.isPresent()) {
          Definitions.Definition definition = resolved.get().definition(language);
          all.add(definition);
          Definition place = new Definition(text.file(), i, resolved.get().context());
          places.put(definition, place);
          add(place, DefinitionText.of(clauses.get(i).text()));
        }
      }
    }
    new Definitions(language, new ArrayList<>())
        .declareAll(all)
        .forEach(
            (feature, definition) -> {
              Definition place = places.get(definition);
              definitions.put(feature, place);
              features.put(key(place.file(), place.number()), feature);
            });
  }

  private void add(Definition place, DefinitionText text) {
    String name = Names.qualified(place.owner()) + " " + text.head();
    named.computeIfAbsent(name, none -> new ArrayList<>()).add(place);
    names.put(place, name);
  }

  /** Returns what the language depends on. */
  static List<String> signatures(List<RuleText> texts) {
    return texts.stream()
        .flatMap(
            text ->
                text.definitions().stream()
                    .map(
                        each ->
                            String.join(
                                "\n",
                                text.file().toString(),
                                String.valueOf(each.packagePath()),
                                each.context().toString(),
                                DefinitionText.of(each.text()).signature(),
                                each.text().text().startsWith("static") ? "static" : "")))
        .collect(Collectors.toList());
  }

  boolean isOf(List<EPackage> present, List<String> signed) {
    return metamodels.equals(present) && signatures.equals(signed);
  }

  ExpressionLanguage language() {
    return language;
  }

  /** Returns the definition that is a feature or operation; {@code null} if none is. */
  Definition definition(Object feature) {
    return definitions.get(feature);
  }

  /** Returns all definitions with the class, name and parameters of one of them. */
  List<Definition> alike(Definition one) {
    return named.get(names.get(one));
  }

  /** Returns the feature or operation of a definition; for a repeated one, that of the first. */
  Optional<Object> feature(Path file, int number) {
    Object own = features.get(key(file, number));
    return own != null
        ? Optional.of(own)
        : names.keySet().stream()
            .filter(each -> each.file().equals(file) && each.number() == number)
            .flatMap(each -> alike(each).stream())
            .map(each -> features.get(key(each.file(), each.number())))
            .filter(Objects::nonNull)
            .findFirst();
  }

  private static String key(Path file, int number) {
    return number + " " + file;
  }
}
