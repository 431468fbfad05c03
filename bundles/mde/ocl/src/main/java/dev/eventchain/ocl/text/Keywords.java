package dev.eventchain.ocl.text;

import java.util.List;
import java.util.stream.Stream;
import org.eclipse.ocl.parser.OCLParsersym;

/** Words with a meaning of their own in Complete OCL: those of the parser, and of documents. */
public final class Keywords {

  /** Words that begin an import besides {@code import}, which the parser does not know. */
  private static final List<String> OF_DOCUMENTS = List.of("include", "library");

  /** A type that the parser knows, but for which there are no values. */
  private static final String MESSAGE = "OclMessage";

  /** The keywords, in alphabetical order. */
  public static final List<String> ALL =
      Stream.concat(symbols("[a-z]+"), OF_DOCUMENTS.stream()).sorted().toList();

  /** The predefined types, in alphabetical order. */
  public static final List<String> TYPES =
      symbols("[A-Z]\\w*[a-z]").filter(type -> !type.equals(MESSAGE)).sorted().toList();

  private Keywords() {}

  /** Returns the terminal symbols of the grammar with such a name; others are in upper case. */
  private static Stream<String> symbols(String pattern) {
    return Stream.of(OCLParsersym.orderedTerminalSymbols).filter(symbol -> symbol.matches(pattern));
  }
}
