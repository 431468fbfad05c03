package dev.eventchain.retrieval;

import dev.eventchain.catalogue.SignalGroup;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.logging.Level;
import java.util.logging.Logger;
import org.apache.lucene.analysis.core.WhitespaceAnalyzer;
import org.apache.lucene.document.Document;
import org.apache.lucene.document.Field;
import org.apache.lucene.document.TextField;
import org.apache.lucene.index.DirectoryReader;
import org.apache.lucene.index.IndexWriter;
import org.apache.lucene.index.IndexWriterConfig;
import org.apache.lucene.index.Term;
import org.apache.lucene.search.BooleanClause;
import org.apache.lucene.search.BooleanQuery;
import org.apache.lucene.search.BoostQuery;
import org.apache.lucene.search.IndexSearcher;
import org.apache.lucene.search.ScoreDoc;
import org.apache.lucene.search.TermQuery;
import org.apache.lucene.store.ByteBuffersDirectory;

/**
 * An index of groups of signals by the words of their paths, of their meanings with units and
 * allowed values, and of the meanings of the groups that they are in; ranked by BM25 (Robertson and
 * Zaragoza, 2009). The same groups and texts give the same order.
 */
final class SignalIndex {

  private static final String PATH = "path";
  private static final String INSTANCES = "instances";
  private static final String MEANING = "meaning";
  private static final String GROUPS = "groups";

  /**
   * Most words of a query; later ones of a longer text are left out. Lucene takes 1,024 clauses,
   * and a word becomes four.
   */
  private static final int LONGEST = 250;

  /** Weight of what a branch means: its words are those of many signals. */
  private static final double OF_GROUPS = 0.3;

  /** Weight of a word that does not stand in the text itself. */
  private static final double OF_SYNONYMS = 0.5;

  /**
   * Kept, since loggers are forgotten with their levels. Its hints are about Java's own options.
   */
  private static final Logger LUCENE = Logger.getLogger("org.apache.lucene");

  static {
    LUCENE.setLevel(Level.SEVERE);
  }

  private final List<SignalGroup> groups;
  private final Synonyms synonyms;
  private final IndexSearcher searcher;

  SignalIndex(List<SignalGroup> groups, Synonyms synonyms) {
    this.groups = List.copyOf(groups);
    this.synonyms = synonyms;
    ByteBuffersDirectory memory = new ByteBuffersDirectory();
    IndexWriterConfig config = new IndexWriterConfig(new WhitespaceAnalyzer());
    try (IndexWriter writer = new IndexWriter(memory, config)) {
      for (SignalGroup group : groups) {
        writer.addDocument(document(group));
      }
      writer.forceMerge(1);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    this.searcher = searcher(memory);
  }

  private static IndexSearcher searcher(ByteBuffersDirectory memory) {
    try {
      return new IndexSearcher(DirectoryReader.open(memory));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static Document document(SignalGroup group) {
    Document document = new Document();
    document.add(field(PATH, group.path().replaceAll("\\{[^}]*}", " ")));
    document.add(field(INSTANCES, group.path().replaceAll("(^|})[^{]*", " ")));
    document.add(field(MEANING, group.any().meaning() + " " + group.any().unit()));
    document.add(field(GROUPS, String.join(" ", group.any().groups())));
    return document;
  }

  private static Field field(String name, String text) {
    return new TextField(name, String.join(" ", Words.of(text)), Field.Store.NO);
  }

  /**
   * Returns the groups that have a word of a text or a synonym, best first.
   *
   * @param most how many at most
   */
  List<SignalGroup> find(String text, int most) {
    List<String> words = Words.of(text);
    List<String> all = words.subList(0, Math.min(LONGEST, words.size()));
    BooleanQuery.Builder query = new BooleanQuery.Builder();
    Set<String> own = new LinkedHashSet<>(all);
    own.forEach(word -> add(query, word, 1));
    synonyms.of(all).stream()
        .limit(LONGEST - own.size())
        .forEach(it -> add(query, it, OF_SYNONYMS));
    List<SignalGroup> found = new ArrayList<>();
    try {
      for (ScoreDoc each : searcher.search(query.build(), most).scoreDocs) {
        found.add(groups.get(each.doc));
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return found;
  }

  private static void add(BooleanQuery.Builder query, String word, double weight) {
    add(query, PATH, word, weight);
    add(query, MEANING, word, weight);
    add(query, GROUPS, word, weight * OF_GROUPS);
    add(query, INSTANCES, word, weight * OF_GROUPS);
  }

  private static void add(BooleanQuery.Builder query, String field, String word, double weight) {
    TermQuery term = new TermQuery(new Term(field, word));
    query.add(new BoostQuery(term, (float) weight), BooleanClause.Occur.SHOULD);
  }
}
