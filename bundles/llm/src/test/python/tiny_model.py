"""Writes a language model of 0.5 MB with random weights, for tests of the wire: `python tiny_model.py FILE CONTEXT`.

It says nonsense of printable characters. The first dimension of its embeddings is constant, so that the first column of
the output layer is a bias: no raw bytes, now and then a quotation mark, a bracket or the end.
"""

from __future__ import annotations

import sys

import gguf
import numpy as np

DIMENSION, LAYERS, HEADS, FEED_FORWARD = 64, 2, 4, 128
GAIN = 0.6  # of a bias; the norm in front of the output layer multiplies the constant by 5 to 7
BIASES = {b'"': 1.0, b"}": 1.0, b"]": 0.45, b"</s>": 1.2, b"\\": -3.0, "\u2581".encode(): -3.0}
TEMPLATE = (
    "{% for m in messages %}{{ m['role'] }}: {{ m['content'] }}\n{% endfor %}"
    "{% if add_generation_prompt %}assistant: {% endif %}"
)


def vocabulary() -> tuple[list[bytes], list[int]]:
    """All bytes, and the printable characters as tokens of their own."""
    kinds = gguf.TokenType
    tokens = [b"<unk>", b"<s>", b"</s>", *(f"<0x{byte:02X}>".encode() for byte in range(256))]
    types = [kinds.UNKNOWN, kinds.CONTROL, kinds.CONTROL, *([kinds.BYTE] * 256)]
    normal = [*(bytes([code]) for code in range(33, 127)), "\u2581".encode()]
    return tokens + normal, types + [kinds.NORMAL] * len(normal)


def describe(writer: gguf.GGUFWriter, tokens: list[bytes], types: list[int]) -> None:
    """Write what the model is like."""
    writer.add_name("tiny-random")
    writer.add_context_length(int(sys.argv[2]))
    writer.add_embedding_length(DIMENSION)
    writer.add_block_count(LAYERS)
    writer.add_feed_forward_length(FEED_FORWARD)
    writer.add_head_count(HEADS)
    writer.add_head_count_kv(HEADS)
    writer.add_rope_dimension_count(DIMENSION // HEADS)
    writer.add_layer_norm_rms_eps(1e-5)
    writer.add_vocab_size(len(tokens))
    writer.add_file_type(gguf.LlamaFileType.ALL_F32)
    writer.add_tokenizer_model("llama")
    writer.add_tokenizer_pre("default")
    writer.add_token_list(tokens)
    writer.add_token_scores([-float(index) if kind == gguf.TokenType.NORMAL else 0.0 for index, kind in enumerate(types)])
    writer.add_token_types(types)
    writer.add_bos_token_id(1)
    writer.add_eos_token_id(2)
    writer.add_unk_token_id(0)
    writer.add_add_bos_token(True)
    writer.add_add_space_prefix(False)
    writer.add_chat_template(TEMPLATE)


def add_weights(writer: gguf.GGUFWriter, tokens: list[bytes], types: list[int]) -> None:
    """Write the weights, which are the same each time."""
    generator = np.random.default_rng(42)

    def weights(rows: int, columns: int, deviation: float = 0.06) -> np.ndarray:
        return (generator.standard_normal((rows, columns)) * deviation).astype(np.float32)

    def without_constant(rows: int, columns: int) -> np.ndarray:
        matrix = weights(rows, columns)
        matrix[0] = 0
        return matrix

    embedding = weights(len(tokens), DIMENSION, 0.3)
    embedding[:, 0] = 3.0
    output = weights(len(tokens), DIMENSION, 0.08)
    for index, token in enumerate(tokens):
        letter = len(token) == 1 and token.islower()
        usual = -3.0 if types[index] == gguf.TokenType.BYTE else 0.3 if letter else 0.0
        output[index, 0] = BIASES.get(token, usual) * GAIN
    ones = np.ones(DIMENSION, np.float32)
    writer.add_tensor("token_embd.weight", embedding)
    for layer in range(LAYERS):
        name = f"blk.{layer}."
        writer.add_tensor(name + "attn_norm.weight", ones)
        for part in ("attn_q", "attn_k", "attn_v"):
            writer.add_tensor(f"{name}{part}.weight", weights(DIMENSION, DIMENSION))
        writer.add_tensor(name + "attn_output.weight", without_constant(DIMENSION, DIMENSION))
        writer.add_tensor(name + "ffn_norm.weight", ones)
        writer.add_tensor(name + "ffn_gate.weight", weights(FEED_FORWARD, DIMENSION))
        writer.add_tensor(name + "ffn_up.weight", weights(FEED_FORWARD, DIMENSION))
        writer.add_tensor(name + "ffn_down.weight", without_constant(DIMENSION, FEED_FORWARD))
    writer.add_tensor("output_norm.weight", ones)
    writer.add_tensor("output.weight", output)


def main() -> None:
    """Write the file."""
    tokens, types = vocabulary()
    writer = gguf.GGUFWriter(sys.argv[1], "llama")
    describe(writer, tokens, types)
    add_weights(writer, tokens, types)
    writer.write_header_to_file()
    writer.write_kv_data_to_file()
    writer.write_tensors_to_file()
    writer.close()


if __name__ == "__main__":
    main()
