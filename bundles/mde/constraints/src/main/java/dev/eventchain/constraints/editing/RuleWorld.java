package dev.eventchain.constraints.editing;

import dev.eventchain.constraints.document.Contexts;
import dev.eventchain.constraints.document.ResolvedClause;
import dev.eventchain.constraints.document.RuleDocument;
import dev.eventchain.ocl.Definitions;
import dev.eventchain.ocl.ExpressionLanguage;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EPackage;

/**
 * The language that the documents of some metamodels share: their definitions are known in all of
 * them. It stays the same until the signature of a definition changes.
 */
final class RuleWorld {

  /**
   * A definition: the document, its number among the definitions there, and the class that it
   * extends.
   */
  record Definition(Path file, int number, EClassifier owner) {}

  private final ExpressionLanguage language;
  private final List<String> signatures;
  private final IdentityHashMap<Object, Definition> definitions = new IdentityHashMap<>();
  private final Map<String, Object> features = new HashMap<>();

  RuleWorld(List<EPackage> metamodels, List<RuleText> texts) {
    this.language = ExpressionLanguage.of(metamodels);
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
          places.put(definition, new Definition(text.file(), i, resolved.get().context()));
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

  boolean isOf(List<RuleText> texts) {
    return signatures.equals(signatures(texts));
  }

  ExpressionLanguage language() {
    return language;
  }

  /** Returns the definition that is a feature or operation; {@code null} if none is. */
  Definition definition(Object feature) {
    return definitions.get(feature);
  }

  /** Returns the feature or operation of a definition. */
  Optional<Object> feature(Path file, int number) {
    return Optional.ofNullable(features.get(key(file, number)));
  }

  private static String key(Path file, int number) {
    return number + " " + file;
  }
}
