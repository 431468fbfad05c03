package dev.eventchain.openscenario.vocabulary;

import java.util.List;
import java.util.Optional;

/** The words that an attribute may have as its value. */
public record Enumeration(String name, Version since, List<Literal> literals) {

  /**
   * A word.
   *
   * @param latest the word of the latest version for the same; mostly the word itself
   */
  public record Literal(String word, Version since, String latest) {}

  /** Copies the literals. */
  public Enumeration {
    literals = List.copyOf(literals);
  }

  /** Returns a literal. */
  public Optional<Literal> literal(String word) {
    return literals.stream().filter(each -> each.word().equals(word)).findFirst();
  }

  /** Returns all words, those of earlier versions too. */
  public List<String> words() {
    return literals.stream().map(Literal::word).toList();
  }
}
