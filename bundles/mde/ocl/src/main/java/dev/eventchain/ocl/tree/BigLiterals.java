package dev.eventchain.ocl.tree;

import dev.eventchain.ocl.values.Numbers;
import java.math.BigInteger;
import org.eclipse.emf.common.notify.Adapter;
import org.eclipse.emf.common.notify.impl.AdapterImpl;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.util.EcoreUtil;
import org.eclipse.ocl.cst.CSTFactory;
import org.eclipse.ocl.cst.IntegerLiteralExpCS;
import org.eclipse.ocl.expressions.IntegerLiteralExp;
import org.eclipse.ocl.parser.OCLLexer;
import org.eclipse.ocl.parser.OCLParser;

/** Integer literals of any size; Eclipse OCL only supports those that fit a long. */
public final class BigLiterals {

  /** Stores the value of a literal in place of Eclipse OCL's. */
  private static final class Value extends AdapterImpl {
    private final BigInteger number;

    Value(BigInteger number) {
      this.number = number;
    }

    @Override
    public boolean isAdapterForType(Object type) {
      return type == Value.class;
    }
  }

  /** Reads literals of any size. */
  public static final class Parser extends OCLParser {
    public Parser(OCLLexer lexer) {
      super(lexer);
    }

    @Override
    protected IntegerLiteralExpCS createIntegerLiteralExpCS(String text) {
      if (!isBig(text)) {
        return super.createIntegerLiteralExpCS(text);
      }
      IntegerLiteralExpCS literal = CSTFactory.eINSTANCE.createIntegerLiteralExpCS();
      literal.setSymbol(text);
      literal.setLongSymbol(Long.MAX_VALUE);
      return literal;
    }
  }

  private BigLiterals() {}

  private static boolean isBig(String text) {
    return text.length() > 18 && new BigInteger(text).bitLength() >= Long.SIZE;
  }

  /** Sets the value of a literal as written. */
  public static void complete(IntegerLiteralExp<?> literal, String text) {
    if (isBig(text)) {
      ((EObject) literal).eAdapters().add(new Value(new BigInteger(text)));
    }
  }

  public static Object valueOf(IntegerLiteralExp<EClassifier> literal) {
    Adapter value = EcoreUtil.getExistingAdapter((EObject) literal, Value.class);
    return value == null
        ? Numbers.integer(literal.getLongSymbol())
        : Numbers.integer(((Value) value).number);
  }
}
