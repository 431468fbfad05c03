package dev.eventchain.catalogue.dbc;

import dev.eventchain.catalogue.dbc.DbcTokens.Kind;
import dev.eventchain.catalogue.dbc.DbcTokens.Token;
import dev.eventchain.catalogue.dbc.DbcTokens.UnreadException;
import dev.eventchain.catalogue.network.Network;
import dev.eventchain.catalogue.network.NetworkMessage;
import dev.eventchain.catalogue.network.NetworkSignal;
import dev.eventchain.catalogue.network.SendingCondition;
import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.ObjIntConsumer;

/** Statements about messages and signals that come after them. */
final class DbcFacts {

  /** Codings by their numbers. */
  private static final List<NetworkSignal.Coding> CODINGS =
      List.of(
          NetworkSignal.Coding.INTEGER, NetworkSignal.Coding.FLOAT, NetworkSignal.Coding.DOUBLE);

  private static final String CYCLE = "GenMsgCycleTime";
  private static final String LONG_MESSAGE = "SystemMessageLongSymbol";
  private static final String LONG_SIGNAL = "SystemSignalLongSymbol";

  private final Network network;
  private final DbcStatement part;
  private final ObjIntConsumer<String> warnings;

  /**
   * Creates a reader.
   *
   * @param warnings takes findings about what is not in the file, with their offsets
   */
  DbcFacts(Network network, DbcStatement part, ObjIntConsumer<String> warnings) {
    this.network = network;
    this.part = part;
    this.warnings = warnings;
  }

  void comment() throws UnreadException {
    if (part.isNext(Kind.WORD)) {
      Token about = part.word();
      if (about.is("BO_")) {
        Optional<NetworkMessage> message = message();
        String text = part.text();
        message.ifPresent(it -> it.comment(text));
      } else if (about.is("SG_")) {
        Optional<NetworkSignal> signal = signal();
        String text = part.text();
        signal.ifPresent(it -> it.comment(text));
      }
    }
    part.pass();
  }

  /** Reads the meanings of raw numbers of a signal; those of an environment variable are passed. */
  void texts() throws UnreadException {
    if (part.isNext(Kind.NUMBER)) {
      Optional<NetworkSignal> signal = signal();
      Map<BigDecimal, String> texts = new LinkedHashMap<>();
      while (part.isNext(Kind.NUMBER)) {
        BigDecimal number = part.number().stripTrailingZeros();
        texts.put(number, part.text());
      }
      signal.ifPresent(it -> it.texts().putAll(texts));
      part.sign(";");
    } else {
      part.pass();
    }
  }

  void attribute() throws UnreadException {
    String name = part.text();
    Token about = part.isNext(Kind.WORD) ? part.word() : new Token(Kind.END, "", 0, false);
    if (about.is("BO_")) {
      Optional<NetworkMessage> message = message();
      if (name.equals(CYCLE) && part.isNext(Kind.NUMBER)) {
        int cycle = milliseconds();
        message.ifPresent(it -> it.cycle(cycle));
      } else if (name.equals(LONG_MESSAGE) && part.isNext(Kind.TEXT)) {
        String full = part.text();
        message.ifPresent(it -> it.rename(full));
      }
    } else if (about.is("SG_")) {
      Optional<NetworkSignal> signal = signal();
      if (name.equals(LONG_SIGNAL) && part.isNext(Kind.TEXT)) {
        String full = part.text();
        signal.ifPresent(it -> it.rename(full));
      }
    }
    part.pass();
  }

  /** Reads the value of an attribute where none is stated. */
  void usual() throws UnreadException {
    if (part.text().equals(CYCLE) && part.isNext(Kind.NUMBER)) {
      network.usualCycle(milliseconds());
    }
    part.pass();
  }

  private int milliseconds() throws UnreadException {
    BigDecimal time = part.number();
    boolean known = time.signum() > 0 && time.compareTo(BigDecimal.valueOf(Integer.MAX_VALUE)) <= 0;
    return known ? time.setScale(0, RoundingMode.CEILING).intValue() : 0;
  }

  void coding() throws UnreadException {
    Optional<NetworkSignal> signal = signal();
    part.takes(":");
    int number = (int) part.whole(CODINGS.size() - 1);
    signal.ifPresent(it -> it.coding(CODINGS.get(number)));
    part.pass();
  }

  /** Reads with which numbers of a multiplexer a signal is there. */
  void multiplexed() throws UnreadException {
    Optional<NetworkMessage> message = message();
    Optional<NetworkSignal> signal = signal(message);
    Optional<NetworkSignal> multiplexer = signal(message);
    List<SendingCondition.Range> ranges = new ArrayList<>();
    do {
      BigDecimal from = part.number();
      boolean apart = part.takes("-");
      BigDecimal to = apart ? part.number() : part.number().negate();
      ranges.add(new SendingCondition.Range(from, to));
    } while (part.takes(","));
    if (signal.isPresent() && multiplexer.isPresent()) {
      signal.get().condition(new SendingCondition(multiplexer.get(), ranges));
    }
    part.pass();
  }

  void senders() throws UnreadException {
    Optional<NetworkMessage> message = message();
    part.takes(":");
    while (part.isNext(Kind.WORD)) {
      String sender = part.word().text();
      message.ifPresent(it -> it.senders().add(sender));
      part.takes(",");
    }
    part.pass();
  }

  private Optional<NetworkMessage> message() throws UnreadException {
    int offset = part.offset();
    long number = part.whole(NetworkMessage.LARGEST_NUMBER);
    Optional<NetworkMessage> message = network.find(number);
    if (message.isEmpty()) {
      warnings.accept("There is no message with the identifier " + number + ".", offset);
    }
    return message;
  }

  private Optional<NetworkSignal> signal() throws UnreadException {
    return signal(message());
  }

  private Optional<NetworkSignal> signal(Optional<NetworkMessage> message) throws UnreadException {
    int offset = part.offset();
    String name = part.word().text();
    if (message.isEmpty() || message.get().isNeverSent()) {
      return Optional.empty();
    }
    Optional<NetworkSignal> signal = Optional.ofNullable(message.get().signals().get(name));
    if (signal.isEmpty()) {
      warnings.accept(
          "The message '%s' has no signal '%s'.".formatted(message.get().name(), name), offset);
    }
    return signal;
  }
}
