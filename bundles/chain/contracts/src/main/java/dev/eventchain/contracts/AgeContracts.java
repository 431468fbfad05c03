package dev.eventchain.contracts;

import dev.eventchain.messages.FieldType;
import dev.eventchain.model.eventchain.Data;
import dev.eventchain.model.eventchain.EventchainPackage.Literals;
import java.math.BigInteger;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * Checks that maximum ages and transport times are valid, and that a field can hold the safe value
 * for outdated inputs.
 */
final class AgeContracts {

  private static final Pattern WHOLE = Pattern.compile("-?(0|[1-9][0-9]*)");
  private static final Pattern DECIMAL =
      Pattern.compile("-?(0|[1-9][0-9]*)([.][0-9]+)?([eE][+-]?[0-9]+)?");

  /**
   * Longest text that is parsed as a number; no field holds longer ones, and parsing them takes
   * long.
   */
  private static final int LONGEST_NUMBER = 400;

  private final TypeContracts types;
  private final Findings findings;

  AgeContracts(TypeContracts types, Findings findings) {
    this.types = types;
    this.findings = findings;
  }

  void check(Topic topic) {
    List<Data> all =
        Stream.concat(topic.subscribers().stream(), topic.publishers().stream())
            .flatMap(end -> end.data().stream())
            .toList();
    all.stream().filter(Data::isSetMaximumAge).forEach(this::checkAge);
    all.stream().filter(Data::isSetWorstCaseTransportTime).forEach(this::checkTransport);
    for (Endpoint publisher : topic.publishers()) {
      publisher.data().stream().filter(data -> data.getSafeValue() != null).forEach(this::check);
    }
  }

  /** Checks an age here, because OCL cannot tell zero from an unset value. */
  private void checkAge(Data data) {
    findings.checked(ContractRule.AGE);
    if (!(data.getMaximumAge() > 0) || Double.isInfinite(data.getMaximumAge())) {
      findings.error(
          ContractRule.AGE,
          findings.at(data, Literals.DATA__MAXIMUM_AGE),
          "'%s' has an impossible maximum age of %s ms."
              .formatted(data.getName(), data.getMaximumAge()),
          "Give a finite number above zero, or none: then five periods of the component that writes"
              + " it are the limit.");
    }
  }

  private void checkTransport(Data data) {
    findings.checked(ContractRule.TRANSPORT);
    double time = data.getWorstCaseTransportTime();
    if (!(time >= 0) || Double.isInfinite(time)) {
      findings.error(
          ContractRule.TRANSPORT,
          findings.at(data, Literals.DATA__WORST_CASE_TRANSPORT_TIME),
          "'%s' has an impossible transport time of %s ms.".formatted(data.getName(), time),
          "Give milliseconds, zero or more, or none: then messages stay on one machine.");
    }
  }

  private void check(Data data) {
    types
        .fieldType(data)
        .ifPresent(
            type -> {
              findings.checked(ContractRule.SAFE_VALUE);
              if (!fits(data.getSafeValue(), type)) {
                findings.error(
                    ContractRule.SAFE_VALUE,
                    findings.at(data, Literals.DATA__SAFE_VALUE),
                    "The safe value of '%s' is '%s', which a field of the type %s cannot hold."
                        .formatted(data.getName(), data.getSafeValue(), type),
                    "Write %s, or leave it out: then nothing is published."
                        .formatted(wanted(type)));
              }
            });
  }

  private static boolean fits(String value, FieldType type) {
    if (type.shape() != FieldType.Shape.SINGLE) {
      return false;
    }
    return switch (type.kind()) {
      case BOOL -> value.equals("true") || value.equals("false");
      case CHAR, UINT8 -> isWhole(value, 8, false);
      case UINT16 -> isWhole(value, 16, false);
      case UINT32 -> isWhole(value, 32, false);
      case UINT64 -> isWhole(value, 64, false);
      case INT8 -> isWhole(value, 8, true);
      case INT16 -> isWhole(value, 16, true);
      case INT32 -> isWhole(value, 32, true);
      case INT64 -> isWhole(value, 64, true);
      case FLOAT32 -> isDecimal(value) && Float.isFinite(Float.parseFloat(value));
      case FLOAT64 -> isDecimal(value) && Double.isFinite(Double.parseDouble(value));
      case STRING ->
          type.stringBound() == 0
              || value.getBytes(StandardCharsets.UTF_8).length <= type.stringBound();
      case BYTE, MESSAGE -> false;
    };
  }

  private static boolean isWhole(String value, int bits, boolean signed) {
    if (value.length() > LONGEST_NUMBER || !WHOLE.matcher(value).matches()) {
      return false;
    }
    BigInteger number = new BigInteger(value);
    return signed ? number.bitLength() < bits : number.signum() >= 0 && number.bitLength() <= bits;
  }

  private static boolean isDecimal(String value) {
    return value.length() <= LONGEST_NUMBER && DECIMAL.matcher(value).matches();
  }

  private static String wanted(FieldType type) {
    return switch (type.kind()) {
      case BOOL -> "true or false";
      case FLOAT32, FLOAT64 -> "a single finite number such as 0.0";
      case STRING -> "a string no longer than the field allows";
      case BYTE, MESSAGE -> "safe values only for single numbers, Booleans and strings";
      default -> "a single whole number in the range of the type";
    };
  }
}
