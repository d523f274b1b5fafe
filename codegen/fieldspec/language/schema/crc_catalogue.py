"""The public CRCs of up to 64 bits: facts of the catalogue of parametrised CRC algorithms by Greg Cook.

Source: https://reveng.sourceforge.io/crc-catalogue/, which states the parameters of each algorithm as it is used in
public. Parameters are facts and carry no licence; no text of the catalogue is copied. `crccheck` and `anycrc`, which
have the same algorithms from the same source, judge the table in the tests.

The columns: name, width in bits, polynomial without its highest bit, initial value, order of the bits of each byte and
of the result, what is added to the result by exclusive or, and the checksum of the characters `123456789`.
"""

CRC_CATALOGUE = """\
crc3_gsm 3 0x3 0x0 forward forward 0x7 0x4
crc3_rohc 3 0x3 0x7 reflected reflected 0x0 0x6
crc4_g_704 4 0x3 0x0 reflected reflected 0x0 0x7
crc4_interlaken 4 0x3 0xF forward forward 0xF 0xB
crc5_epc_c1g2 5 0x09 0x09 forward forward 0x00 0x00
crc5_g_704 5 0x15 0x00 reflected reflected 0x00 0x07
crc5_usb 5 0x05 0x1F reflected reflected 0x1F 0x19
crc6_cdma2000_a 6 0x27 0x3F forward forward 0x00 0x0D
crc6_cdma2000_b 6 0x07 0x3F forward forward 0x00 0x3B
crc6_darc 6 0x19 0x00 reflected reflected 0x00 0x26
crc6_g_704 6 0x03 0x00 reflected reflected 0x00 0x06
crc6_gsm 6 0x2F 0x00 forward forward 0x3F 0x13
crc7_mmc 7 0x09 0x00 forward forward 0x00 0x75
crc7_rohc 7 0x4F 0x7F reflected reflected 0x00 0x53
crc7_umts 7 0x45 0x00 forward forward 0x00 0x61
crc8_autosar 8 0x2F 0xFF forward forward 0xFF 0xDF
crc8_bluetooth 8 0xA7 0x00 reflected reflected 0x00 0x26
crc8_cdma2000 8 0x9B 0xFF forward forward 0x00 0xDA
crc8_darc 8 0x39 0x00 reflected reflected 0x00 0x15
crc8_dvb_s2 8 0xD5 0x00 forward forward 0x00 0xBC
crc8_gsm_a 8 0x1D 0x00 forward forward 0x00 0x37
crc8_gsm_b 8 0x49 0x00 forward forward 0xFF 0x94
crc8_hitag 8 0x1D 0xFF forward forward 0x00 0xB4
crc8_i_432_1 8 0x07 0x00 forward forward 0x55 0xA1
crc8_i_code 8 0x1D 0xFD forward forward 0x00 0x7E
crc8_lte 8 0x9B 0x00 forward forward 0x00 0xEA
crc8_maxim_dow 8 0x31 0x00 reflected reflected 0x00 0xA1
crc8_mifare_mad 8 0x1D 0xC7 forward forward 0x00 0x99
crc8_nrsc_5 8 0x31 0xFF forward forward 0x00 0xF7
crc8_opensafety 8 0x2F 0x00 forward forward 0x00 0x3E
crc8_rohc 8 0x07 0xFF reflected reflected 0x00 0xD0
crc8_sae_j1850 8 0x1D 0xFF forward forward 0xFF 0x4B
crc8_smbus 8 0x07 0x00 forward forward 0x00 0xF4
crc8_tech_3250 8 0x1D 0xFF reflected reflected 0x00 0x97
crc8_wcdma 8 0x9B 0x00 reflected reflected 0x00 0x25
crc10_atm 10 0x233 0x000 forward forward 0x000 0x199
crc10_cdma2000 10 0x3D9 0x3FF forward forward 0x000 0x233
crc10_gsm 10 0x175 0x000 forward forward 0x3FF 0x12A
crc11_flexray 11 0x385 0x01A forward forward 0x000 0x5A3
crc11_umts 11 0x307 0x000 forward forward 0x000 0x061
crc12_cdma2000 12 0xF13 0xFFF forward forward 0x000 0xD4D
crc12_dect 12 0x80F 0x000 forward forward 0x000 0xF5B
crc12_gsm 12 0xD31 0x000 forward forward 0xFFF 0xB34
crc12_umts 12 0x80F 0x000 forward reflected 0x000 0xDAF
crc13_bbc 13 0x1CF5 0x0000 forward forward 0x0000 0x04FA
crc14_darc 14 0x0805 0x0000 reflected reflected 0x0000 0x082D
crc14_gsm 14 0x202D 0x0000 forward forward 0x3FFF 0x30AE
crc15_can 15 0x4599 0x0000 forward forward 0x0000 0x059E
crc15_mpt1327 15 0x6815 0x0000 forward forward 0x0001 0x2566
crc16_arc 16 0x8005 0x0000 reflected reflected 0x0000 0xBB3D
crc16_cdma2000 16 0xC867 0xFFFF forward forward 0x0000 0x4C06
crc16_cms 16 0x8005 0xFFFF forward forward 0x0000 0xAEE7
crc16_dds_110 16 0x8005 0x800D forward forward 0x0000 0x9ECF
crc16_dect_r 16 0x0589 0x0000 forward forward 0x0001 0x007E
crc16_dect_x 16 0x0589 0x0000 forward forward 0x0000 0x007F
crc16_dnp 16 0x3D65 0x0000 reflected reflected 0xFFFF 0xEA82
crc16_en_13757 16 0x3D65 0x0000 forward forward 0xFFFF 0xC2B7
crc16_genibus 16 0x1021 0xFFFF forward forward 0xFFFF 0xD64E
crc16_gsm 16 0x1021 0x0000 forward forward 0xFFFF 0xCE3C
crc16_ibm_3740 16 0x1021 0xFFFF forward forward 0x0000 0x29B1
crc16_ibm_sdlc 16 0x1021 0xFFFF reflected reflected 0xFFFF 0x906E
crc16_iso_iec_14443_3_a 16 0x1021 0xC6C6 reflected reflected 0x0000 0xBF05
crc16_kermit 16 0x1021 0x0000 reflected reflected 0x0000 0x2189
crc16_lj1200 16 0x6F63 0x0000 forward forward 0x0000 0xBDF4
crc16_m17 16 0x5935 0xFFFF forward forward 0x0000 0x772B
crc16_maxim_dow 16 0x8005 0x0000 reflected reflected 0xFFFF 0x44C2
crc16_mcrf4xx 16 0x1021 0xFFFF reflected reflected 0x0000 0x6F91
crc16_modbus 16 0x8005 0xFFFF reflected reflected 0x0000 0x4B37
crc16_nrsc_5 16 0x080B 0xFFFF reflected reflected 0x0000 0xA066
crc16_opensafety_a 16 0x5935 0x0000 forward forward 0x0000 0x5D38
crc16_opensafety_b 16 0x755B 0x0000 forward forward 0x0000 0x20FE
crc16_profibus 16 0x1DCF 0xFFFF forward forward 0xFFFF 0xA819
crc16_riello 16 0x1021 0xB2AA reflected reflected 0x0000 0x63D0
crc16_spi_fujitsu 16 0x1021 0x1D0F forward forward 0x0000 0xE5CC
crc16_t10_dif 16 0x8BB7 0x0000 forward forward 0x0000 0xD0DB
crc16_teledisk 16 0xA097 0x0000 forward forward 0x0000 0x0FB3
crc16_tms37157 16 0x1021 0x89EC reflected reflected 0x0000 0x26B1
crc16_umts 16 0x8005 0x0000 forward forward 0x0000 0xFEE8
crc16_usb 16 0x8005 0xFFFF reflected reflected 0xFFFF 0xB4C8
crc16_xmodem 16 0x1021 0x0000 forward forward 0x0000 0x31C3
crc17_can_fd 17 0x1685B 0x00000 forward forward 0x00000 0x04F03
crc21_can_fd 21 0x102899 0x000000 forward forward 0x000000 0x0ED841
crc24_ble 24 0x00065B 0x555555 reflected reflected 0x000000 0xC25A56
crc24_flexray_a 24 0x5D6DCB 0xFEDCBA forward forward 0x000000 0x7979BD
crc24_flexray_b 24 0x5D6DCB 0xABCDEF forward forward 0x000000 0x1F23B8
crc24_interlaken 24 0x328B63 0xFFFFFF forward forward 0xFFFFFF 0xB4F3E6
crc24_lte_a 24 0x864CFB 0x000000 forward forward 0x000000 0xCDE703
crc24_lte_b 24 0x800063 0x000000 forward forward 0x000000 0x23EF52
crc24_openpgp 24 0x864CFB 0xB704CE forward forward 0x000000 0x21CF02
crc24_os_9 24 0x800063 0xFFFFFF forward forward 0xFFFFFF 0x200FA5
crc30_cdma 30 0x2030B9C7 0x3FFFFFFF forward forward 0x3FFFFFFF 0x04C34ABF
crc31_philips 31 0x04C11DB7 0x7FFFFFFF forward forward 0x7FFFFFFF 0x0CE9E46C
crc32_aixm 32 0x814141AB 0x00000000 forward forward 0x00000000 0x3010BF7F
crc32_autosar 32 0xF4ACFB13 0xFFFFFFFF reflected reflected 0xFFFFFFFF 0x1697D06A
crc32_base91_d 32 0xA833982B 0xFFFFFFFF reflected reflected 0xFFFFFFFF 0x87315576
crc32_bzip2 32 0x04C11DB7 0xFFFFFFFF forward forward 0xFFFFFFFF 0xFC891918
crc32_cd_rom_edc 32 0x8001801B 0x00000000 reflected reflected 0x00000000 0x6EC2EDC4
crc32_cksum 32 0x04C11DB7 0x00000000 forward forward 0xFFFFFFFF 0x765E7680
crc32_iscsi 32 0x1EDC6F41 0xFFFFFFFF reflected reflected 0xFFFFFFFF 0xE3069283
crc32_iso_hdlc 32 0x04C11DB7 0xFFFFFFFF reflected reflected 0xFFFFFFFF 0xCBF43926
crc32_jamcrc 32 0x04C11DB7 0xFFFFFFFF reflected reflected 0x00000000 0x340BC6D9
crc32_mef 32 0x741B8CD7 0xFFFFFFFF reflected reflected 0x00000000 0xD2C22F51
crc32_mpeg_2 32 0x04C11DB7 0xFFFFFFFF forward forward 0x00000000 0x0376E6E7
crc32_xfer 32 0x000000AF 0x00000000 forward forward 0x00000000 0xBD0BE338
crc40_gsm 40 0x0004820009 0x0000000000 forward forward 0xFFFFFFFFFF 0xD4164FC646
crc64_ecma_182 64 0x42F0E1EBA9EA3693 0x0000000000000000 forward forward 0x0000000000000000 0x6C40DF5F0B497347
crc64_go_iso 64 0x000000000000001B 0xFFFFFFFFFFFFFFFF reflected reflected 0xFFFFFFFFFFFFFFFF 0xB90956C775A41001
crc64_ms 64 0x259C84CBA6426349 0xFFFFFFFFFFFFFFFF reflected reflected 0x0000000000000000 0x75D4B74F024ECEEA
crc64_nvme 64 0xAD93D23594C93659 0xFFFFFFFFFFFFFFFF reflected reflected 0xFFFFFFFFFFFFFFFF 0xAE8B14860A799888
crc64_redis 64 0xAD93D23594C935A9 0x0000000000000000 reflected reflected 0x0000000000000000 0xE9C6D914C4B8D9CA
crc64_we 64 0x42F0E1EBA9EA3693 0xFFFFFFFFFFFFFFFF forward forward 0xFFFFFFFFFFFFFFFF 0x62EC59E3F1A4F00A
crc64_xz 64 0x42F0E1EBA9EA3693 0xFFFFFFFFFFFFFFFF reflected reflected 0xFFFFFFFFFFFFFFFF 0x995DC9BBDF1939FA
"""

OTHER_NAMES = """\
crc4_itu crc4_g_704
crc5_epc crc5_epc_c1g2
crc5_itu crc5_g_704
crc6_itu crc6_g_704
crc7 crc7_mmc
crc8_itu crc8_i_432_1
crc8_maxim crc8_maxim_dow
crc8 crc8_smbus
crc8_aes crc8_tech_3250
crc8_ebu crc8_tech_3250
crc10 crc10_atm
crc10_i_610 crc10_atm
crc11 crc11_flexray
crc12_x crc12_dect
crc12_3gpp crc12_umts
crc15 crc15_can
crc16_lha crc16_arc
crc_ibm crc16_arc
crc16_darc crc16_genibus
crc16_epc crc16_genibus
crc16_epc_c1g2 crc16_genibus
crc16_i_code crc16_genibus
crc16_autosar crc16_ibm_3740
crc16_ccitt_false crc16_ibm_3740
crc16_iso_hdlc crc16_ibm_sdlc
crc16_iso_iec_14443_3_b crc16_ibm_sdlc
crc16_x_25 crc16_ibm_sdlc
crc_b crc16_ibm_sdlc
crc_a crc16_iso_iec_14443_3_a
crc16_ccitt crc16_kermit
crc16_ccitt_true crc16_kermit
crc16_v_41_lsb crc16_kermit
crc_ccitt crc16_kermit
crc16_maxim crc16_maxim_dow
crc16_iec_61158_2 crc16_profibus
crc16_aug_ccitt crc16_spi_fujitsu
crc16_buypass crc16_umts
crc16_verifone crc16_umts
crc16_acorn crc16_xmodem
crc16_lte crc16_xmodem
crc16_v_41_msb crc16_xmodem
crc24 crc24_openpgp
crc32q crc32_aixm
crc32d crc32_base91_d
crc32_aal5 crc32_bzip2
crc32_dect_b crc32_bzip2
crc32_posix crc32_cksum
crc32_base91_c crc32_iscsi
crc32_castagnoli crc32_iscsi
crc32_interlaken crc32_iscsi
crc32c crc32_iscsi
crc32 crc32_iso_hdlc
crc32_adccp crc32_iso_hdlc
crc32_v_42 crc32_iso_hdlc
crc32_xz crc32_iso_hdlc
crc64 crc64_ecma_182
crc64_go_ecma crc64_xz
"""
"""Other names of these algorithms, each with the name above."""
