package dev.eventchain.catalogue.dbc;

import dev.eventchain.catalogue.dbc.DbcTokens.Kind;
import dev.eventchain.catalogue.dbc.DbcTokens.Token;
import dev.eventchain.catalogue.dbc.DbcTokens.UnreadException;
import dev.eventchain.catalogue.network.Network;
import dev.eventchain.catalogue.network.NetworkMessage;
import dev.eventchain.catalogue.network.NetworkSignal;
import dev.eventchain.catalogue.signal.CatalogueRules;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import java.math.BigDecimal;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;

/**
 * Reader of the statements of a file. One that cannot be read is a finding, after which reading
 * goes on with the next line that begins with a keyword.
 */
final class DbcReader {

  private static final int LARGEST_SIZE = 1 << 16;
  private static final int LONGEST_SIGNAL = 64;

  /** Name of a sender or receiver that is not known. */
  private static final String NOBODY = "Vector__XXX";

  /** Statements about what no signal of a chain has. */
  private static final Set<String> PASSED =
      Set.of(
          "VAL_TABLE_",
          "BA_DEF_",
          "EV_",
          "ENVVAR_DATA_",
          "EV_DATA_",
          "SGTYPE_",
          "SGTYPE_VAL_",
          "SIG_GROUP_",
          "SIG_TYPE_REF_",
          "SIGTYPE_VALTYPE_",
          "BA_DEF_REL_",
          "BA_REL_",
          "BA_DEF_DEF_REL_",
          "BA_DEF_SGTYPE_",
          "BA_SGTYPE_",
          "BU_SG_REL_",
          "BU_EV_REL_",
          "BU_BO_REL_",
          "CAT_DEF_",
          "CAT_",
          "FILTER",
          "NS_DESC_");

  private static final Set<String> READ =
      Set.of(
          "VERSION",
          "NS_",
          "BS_",
          "BU_",
          "BO_",
          "SG_",
          "CM_",
          "VAL_",
          "BA_",
          "BA_DEF_DEF_",
          "SIG_VALTYPE_",
          "SG_MUL_VAL_",
          "BO_TX_BU_");

  private final SourceText source;
  private final Consumer<Diagnostic> findings;
  private final DbcTokens tokens;
  private final DbcStatement part;
  private final Network network = new Network();
  private final DbcFacts facts;

  /** The message to which signals belong; empty after one that cannot be read. */
  private Optional<NetworkMessage> open = Optional.empty();

  DbcReader(SourceText source, Consumer<Diagnostic> findings) throws UnreadException {
    this.source = source;
    this.findings = findings;
    tokens = new DbcTokens(source);
    part = new DbcStatement(tokens);
    facts = new DbcFacts(network, part, this::warn);
  }

  Network read() {
    while (tokens.peek().kind() != Kind.END) {
      try {
        statement(tokens.take());
      } catch (UnreadException e) {
        find(e.getMessage(), source.at(e.offset()), "");
        recover();
      }
    }
    return network;
  }

  /** Goes on to the next line that begins with a keyword. */
  private void recover() {
    while (tokens.peek().kind() != Kind.END && !isKeyword(tokens.peek())) {
      try {
        tokens.take();
      } catch (UnreadException e) {
        find(e.getMessage(), source.at(e.offset()), "");
      }
    }
  }

  private static boolean isKeyword(Token token) {
    return token.first()
        && token.kind() == Kind.WORD
        && (READ.contains(token.text()) || PASSED.contains(token.text()));
  }

  private void statement(Token keyword) throws UnreadException {
    switch (keyword.text()) {
      case "VERSION" -> part.text();
      case "NS_" -> passKeywords();
      case "BS_" -> passSpeed();
      case "BU_" -> nodes();
      case "BO_" -> message();
      case "SG_" -> signal();
      case "CM_" -> facts.comment();
      case "VAL_" -> facts.texts();
      case "BA_" -> facts.attribute();
      case "BA_DEF_DEF_" -> facts.usual();
      case "SIG_VALTYPE_" -> facts.coding();
      case "SG_MUL_VAL_" -> facts.multiplexed();
      case "BO_TX_BU_" -> facts.senders();
      default -> other(keyword);
    }
  }

  private void other(Token keyword) throws UnreadException {
    if (keyword.kind() == Kind.WORD && PASSED.contains(keyword.text())) {
      part.pass();
      return;
    }
    find(
        "'" + keyword.text() + "' does not begin a statement of DBC.",
        source.at(keyword.offset()),
        NearestName.hint(keyword.text(), READ));
    recover();
  }

  /** Passes over keywords on lines of their own. */
  private void passKeywords() throws UnreadException {
    part.sign(":");
    while (tokens.peek().kind() == Kind.WORD && tokens.peekSecond().first()) {
      tokens.take();
    }
  }

  private void passSpeed() throws UnreadException {
    part.sign(":");
    while (!tokens.peek().first()) {
      tokens.take();
    }
  }

  private void nodes() throws UnreadException {
    part.sign(":");
    while (tokens.peek().kind() == Kind.WORD && !isKeyword(tokens.peek())) {
      network.nodes().add(tokens.take().text());
    }
  }

  private void message() throws UnreadException {
    open = Optional.empty();
    Token identifier = tokens.peek();
    long number = part.whole(NetworkMessage.LARGEST_NUMBER);
    Token name = part.word();
    part.sign(":");
    int size = (int) part.whole(LARGEST_SIZE);
    NetworkMessage message = new NetworkMessage(number, name.text(), size);
    Token sender = part.word();
    if (!sender.is(NOBODY)) {
      message.senders().add(sender.text());
    }
    Optional<String> problem = message.identifierProblem();
    if (problem.isPresent()) {
      throw new UnreadException(problem.get(), identifier.offset());
    }
    if (!network.add(message)) {
      throw new UnreadException(
          "There is another message with the identifier " + number + ".", identifier.offset());
    }
    open = Optional.of(message);
  }

  private void signal() throws UnreadException {
    Token name = part.word();
    String multiplexing = part.isNext(Kind.WORD) ? multiplexing(part.word()) : "";
    part.sign(":");
    NetworkSignal.Layout layout = layout();
    String unit = part.text();
    while (!tokens.peek().first() && (part.isNext(Kind.WORD) || tokens.peek().is(","))) {
      tokens.take();
    }
    NetworkSignal signal =
        new NetworkSignal(name.text(), multiplexing, layout, unit, source.at(name.offset()));
    if (open.isPresent() && !open.get().isNeverSent()) {
      open.get().add(signal).ifPresent(problem -> find(problem, signal.place(), ""));
    }
  }

  private static String multiplexing(Token token) throws UnreadException {
    if (!token.text().matches("M|m[0-9]{1,9}M?")) {
      throw new UnreadException(
          "Here ':' is expected, or M or m and a number, not '" + token.text() + "'.",
          token.offset());
    }
    return token.text();
  }

  private NetworkSignal.Layout layout() throws UnreadException {
    int start = (int) part.whole(8L * LARGEST_SIZE);
    part.sign("|");
    Token bits = tokens.peek();
    int length = (int) part.whole(LONGEST_SIGNAL);
    if (length == 0) {
      throw new UnreadException("A signal has at least one bit.", bits.offset());
    }
    part.sign("@");
    boolean bigEndian = part.whole(1) == 0;
    boolean signed = part.takes("-");
    if (!signed) {
      part.sign("+");
    }
    List<BigDecimal> line = pair("(", ",", ")");
    List<BigDecimal> range = pair("[", "|", "]");
    boolean stated = range.stream().anyMatch(it -> it.signum() != 0);
    return new NetworkSignal.Layout(
        start,
        length,
        bigEndian,
        signed,
        line.get(0),
        line.get(1),
        Optional.of(range.get(0)).filter(it -> stated),
        Optional.of(range.get(1)).filter(it -> stated));
  }

  private List<BigDecimal> pair(String open, String between, String close) throws UnreadException {
    part.sign(open);
    BigDecimal one = part.number();
    part.sign(between);
    BigDecimal other = part.number();
    part.sign(close);
    return List.of(one, other);
  }

  private void warn(String message, int offset) {
    findings.accept(Diagnostic.of(CatalogueRules.ATTRIBUTE, message, source.at(offset)));
  }

  private void find(String message, SourceLocation place, String hint) {
    Diagnostic finding = Diagnostic.of(CatalogueRules.ENTRY, message, place);
    findings.accept(hint.isEmpty() ? finding : finding.withHint(hint));
  }
}
