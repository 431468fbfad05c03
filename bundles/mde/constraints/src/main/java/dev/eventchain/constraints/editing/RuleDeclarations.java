package dev.eventchain.constraints.editing;

import dev.eventchain.constraints.document.RuleDocument;
import dev.eventchain.editing.Call;
import dev.eventchain.editing.EcorePlaces;
import dev.eventchain.editing.FileRange;
import dev.eventchain.editing.Symbol;
import dev.eventchain.ocl.editing.Descriptions;
import dev.eventchain.ocl.editing.Mention;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.eclipse.emf.ecore.EObject;

/**
 * Declarations of the names that expressions of some metamodels use, in rule documents and in
 * {@code .ecore} files.
 *
 * @param texts the present texts of the documents
 */
record RuleDeclarations(RuleWorld world, List<RuleText> texts, EcorePlaces ecore) {

  /** Greatest length of a value that is shown. */
  private static final int SHORT = 60;

  private record Found(RuleText text, RuleDocument.Clause clause) {}

  private Optional<Found> clauseOf(RuleWorld.Definition definition) {
    return texts.stream()
        .filter(each -> each.file().equals(definition.file()))
        .findFirst()
        .map(each -> new Found(each, each.definitions().get(definition.number())));
  }

  /** Returns whether a definition of a document is meant. */
  boolean isOwn(Object target) {
    return world.definition(target) != null;
  }

  Optional<FileRange> of(Object target) {
    RuleWorld.Definition definition = world.definition(target);
    if (definition == null) {
      return target instanceof EObject element ? ecore.of(element) : Optional.empty();
    }
    return clauseOf(definition)
        .map(
            found -> {
              DefinitionText parts = DefinitionText.of(found.clause().text());
              int end = parts.nameStart() + parts.name().length();
              return new FileRange(
                  definition.file(), found.text().lines().range(parts.nameStart(), end));
            });
  }

  /** Returns the text about a name; about a definition, with its value if that is short. */
  String describe(Mention mention) {
    return Optional.ofNullable(world.definition(mention.target()))
        .flatMap(this::clauseOf)
        .map(found -> DefinitionText.of(found.clause().text()))
        .map(
            definition -> {
              String value = definition.value().text().strip();
              boolean shown =
                  !value.isEmpty() && value.length() <= SHORT && value.lines().count() == 1;
              return Descriptions.code(definition.signature() + (shown ? " = " + value : ""));
            })
        .orElseGet(() -> Descriptions.of(mention));
  }

  /** Returns why a definition cannot get a name; empty if it can. */
  String collision(Object target, String newName) {
    RuleWorld.Definition definition = world.definition(target);
    List<RuleWorld.Definition> alike = world.alike(definition);
    if (alike.size() > 1) {
      List<String> files = alike.stream().map(each -> each.file().toString()).distinct().toList();
      return String.format(
          Locale.ROOT,
          "It is declared %d times, in %s.",
          alike.size(),
          String.join(" and ", files));
    }
    return world.language().assistant().hasMember(definition.owner(), newName)
        ? "%s or a class below it already has '%s'."
            .formatted(definition.owner().getName(), newName)
        : "";
  }

  /** Returns the definition as what can be called. */
  Optional<Call.Item> item(Object target) {
    return Optional.ofNullable(world.definition(target))
        .flatMap(this::clauseOf)
        .map(
            found -> {
              int section = found.text().sectionAt(found.clause().text().start());
              return item(found.text(), found.text().sections().get(section));
            });
  }

  /** Returns a clause as a caller. */
  static Call.Item item(RuleText text, Section section) {
    Symbol symbol = RuleOutline.symbol(text, section);
    return new Call.Item(
        symbol.name(),
        symbol.detail(),
        symbol.kind(),
        new FileRange(text.file(), symbol.range()),
        symbol.nameRange());
  }
}
