package dev.eventchain.retrieval;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.List;
import org.apache.lucene.analysis.Analyzer;
import org.apache.lucene.analysis.CharArraySet;
import org.apache.lucene.analysis.TokenStream;
import org.apache.lucene.analysis.en.EnglishAnalyzer;
import org.apache.lucene.analysis.tokenattributes.CharTermAttribute;

/** The words of texts and names, as stems without inflections and small words. */
final class Words {

  /** Words of any requirement, besides the small ones of English. */
  private static final List<String> SMALL =
      List.of(
          "after", "always", "any", "before", "can", "each", "from", "how", "it", "may", "must",
          "never", "once", "only", "shall", "should", "system", "than", "until", "what", "when",
          "where", "which", "while", "who", "whose", "without");

  private static final Analyzer ENGLISH = new EnglishAnalyzer(stopWords());

  private Words() {}

  /** Returns the words of a text; names are divided at capital letters, digits and punctuation. */
  static List<String> of(String text) {
    List<String> words = new ArrayList<>();
    try (TokenStream stream = ENGLISH.tokenStream("text", divided(text))) {
      CharTermAttribute word = stream.addAttribute(CharTermAttribute.class);
      stream.reset();
      while (stream.incrementToken()) {
        words.add(word.toString());
      }
      stream.end();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return words;
  }

  private static CharArraySet stopWords() {
    CharArraySet words = new CharArraySet(SMALL, true);
    words.addAll(EnglishAnalyzer.getDefaultStopSet());
    return words;
  }

  private static String divided(String text) {
    return text.replaceAll("(?<=[a-z])(?=[A-Z0-9])|(?<=[A-Z])(?=[A-Z][a-z])", " ")
        .replaceAll("[^\\p{L}\\p{N}]+", " ");
  }
}
