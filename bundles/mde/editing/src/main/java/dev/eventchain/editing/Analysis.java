package dev.eventchain.editing;

import java.util.List;
import java.util.Optional;

/**
 * Answers about one version of a text. Each answer covers what can be read of a half-typed text;
 * where nothing is known, it is empty. Positions outside the text count as its nearest ones.
 * Thread-safe.
 */
public interface Analysis {

  /** Returns the named parts, in the order of the text, for an outline. */
  List<Symbol> symbols();

  /**
   * Returns the named parts that other files may name or look for; the whole outline by default.
   */
  default List<Symbol> workspaceSymbols() {
    return symbols();
  }

  /** Returns what can be folded, in the order of the text. */
  List<Folding> foldings();

  /** Returns the meaning of the words, in the order of the text. */
  List<SemanticToken> tokens();

  /** Returns proposals at a position, the most suitable first. */
  List<Completion> completions(TextPosition position);

  /** Returns what is known about the word at a position. */
  Optional<Hover> hover(TextPosition position);

  /** Returns the signatures of the call whose parentheses are around a position. */
  Optional<SignatureHelp> signatureHelp(TextPosition position);

  /** Returns where that is declared what the word at a position names. */
  List<FileRange> definitions(TextPosition position);

  /** Returns where the type of the word at a position is declared. */
  List<FileRange> typeDefinitions(TextPosition position);

  /** Returns what implements the thing at a position: overriding templates, bodies, subclasses. */
  List<FileRange> implementations(TextPosition position);

  /**
   * Returns where that is named what the word at a position names, in all files of the language.
   *
   * @param declaration true to include where it is declared
   */
  List<FileRange> references(TextPosition position, boolean declaration);

  /** Returns what can be renamed at a position, or why nothing can. */
  RenameTarget renameTarget(TextPosition position);

  /**
   * Renames what the word at a position names, in all files of the language; refused if the new
   * name is not valid there, or would mean or hide something else.
   */
  Rename rename(TextPosition position, String newName);

  /** Returns the ranges around a position, the innermost first, each inside the next. */
  List<TextRange> selectionRanges(TextPosition position);

  /** Returns the hints in a range, in the order of the text. */
  List<InlayHint> inlayHints(TextRange range);

  /** Returns the callable things that the word at a position names. */
  List<Call.Item> callItems(TextPosition position);
}
