"""The codec that is built from the layout at run time with construct: the oracle of all generated ones.

>>> from fieldspec.codec.reference import codec          # a DeviceCodec for a DeviceLayout
>>> codec(layout).records["point"].parse(data)     # a plain construct Struct
"""

from fieldspec.codec.reference.frames import DeviceCodec, codec
from fieldspec.codec.reference.records import CodecError

__all__ = ["CodecError", "DeviceCodec", "codec"]
